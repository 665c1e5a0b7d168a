// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/system/start_names.hpp"

#include "model/system/names.hpp"

namespace resonform {

std::string canonical_start(const std::string& name, const System& system) {
    for (const Notation& entry : system.notation) {
        if (entry.name == name) return entry.kind + "." + entry.variable;
    }
    for (const Variable& variable : system.variables) {
        for (int k = 0; k < variable.order; ++k) {
            if (variable.jet[static_cast<std::size_t>(k)].get_name() == name) return name;
        }
        for (const std::string& kind : constant_kinds(variable.role)) {
            if (kind + "." + variable.name == name) return name;
        }
    }
    return "";
}

std::string user_start(const std::string& canonical, const System& system) {
    for (const Notation& entry : system.notation) {
        if (entry.kind + "." + entry.variable == canonical) return entry.name;
    }
    return canonical;
}

std::vector<std::string> start_names(const System& system) {
    std::vector<std::string> names;
    for (const Variable& variable : system.variables) {
        for (const std::string& kind : constant_kinds(variable.role)) {
            names.push_back(user_start(kind + "." + variable.name, system));
        }
        for (int k = 0; k < variable.order; ++k) {
            names.push_back(variable.jet[static_cast<std::size_t>(k)].get_name());
        }
    }
    return names;
}

} // namespace resonform
