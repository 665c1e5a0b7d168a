// SPDX-License-Identifier: GPL-3.0-or-later
// Unique C++ identifiers within one scope of emitted code.
#pragma once

#include <set>
#include <string>

namespace resonform {

class CppNames {
public:
    // Starts with the words of C++ and of the emitted frame taken.
    CppNames();
    // wish as an identifier, with an underscore behind it if it is taken.
    std::string unique(const std::string& wish);
    // The next of prefix_1, prefix_2, ...
    std::string numbered(const std::string& prefix);

private:
    std::set<std::string> taken_;
    int last_ = 0;
};

} // namespace resonform
