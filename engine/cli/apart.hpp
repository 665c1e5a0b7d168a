// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own, whose end is not the end of the program: a derivation that meets its limits
// ends the process it runs in (cli/watch.hpp).
#pragma once

#include <functional>
#include <string>

namespace resonform {

struct Apart {
    bool ended = false; // by itself; false: the process was killed or failed, `text` has no meaning
    std::string text;   // what `work` returned
};

// Precondition: no other thread runs. What `work` says on standard error is lost. An exception of `work` ends
// its process.
Apart done_apart(const std::function<std::string()>& work);

} // namespace resonform
