// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own, with a limit of processor time: what crashes or never ends is one of the
// results.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace resonform::test {

using Tell = std::function<void(const std::string&)>; // one line

struct Told {
    enum class End { finished, spent, crashed };
    End end = End::crashed;
    int status = 0;                 // of waitpid
    std::vector<std::string> lines; // what was told until then
    [[nodiscard]] std::string last() const { return lines.empty() ? "" : lines.back(); }
};

// work tells lines; an exception that it does not catch is a crash. What it writes on standard output and
// standard error is lost.
Told told_apart(const std::function<void(const Tell&)>& work, double seconds);

} // namespace resonform::test
