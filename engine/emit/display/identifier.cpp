// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/identifier.hpp"

#include <cctype>

namespace resonform {

std::string identifier(const std::string& name) {
    std::string result;
    for (const char c : name) {
        if (c == '\'')
            result += "_dot";
        else
            result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return result.empty() || std::isdigit(static_cast<unsigned char>(result.front())) != 0 ? "_" + result
                                                                                           : result;
}

} // namespace resonform
