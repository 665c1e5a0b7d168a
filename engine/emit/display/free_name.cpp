// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/free_name.hpp"

#include <algorithm>

namespace resonform {

bool is_taken(const System& system, const std::string& name) {
    const auto called = [&](const auto& entry) { return entry.name == name; };
    return name == "eps" || system.variable(name) != nullptr || system.parameter(name) != nullptr ||
           std::any_of(system.functions.begin(), system.functions.end(), called) ||
           std::any_of(system.notation.begin(), system.notation.end(), called);
}

std::string free_name(const System& system, const std::string& wanted) {
    std::string name = wanted;
    while (is_taken(system, name)) name += "_new";
    return name;
}

} // namespace resonform
