// SPDX-License-Identifier: GPL-3.0-or-later
// Where the program finds what belongs to it.
#pragma once

#include <filesystem>

namespace resonform {

// Of an installed program BIN/resonform: BIN/../include/resonform and BIN/../share/resonform. Else engine/
// and the root of the source tree that it was built from.
struct Installation {
    std::filesystem::path headers; // has runtime/, which emitted code includes
    std::filesystem::path data;    // has systems/
};

Installation installation();

} // namespace resonform
