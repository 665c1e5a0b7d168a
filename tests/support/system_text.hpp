// SPDX-License-Identifier: GPL-3.0-or-later
// A system.toml in one line of a test:
//
//   system_text("duffing", {{"x", "fast", "x'' + x + x^3 = 0"}})
#pragma once

#include <string>
#include <vector>

namespace resonform::test {

struct Unknown {
    std::string name, role, equation;
};

// `tables`: those beside [system], [variables] and [equations], as they stand in the file.
inline std::string system_text(const std::string& name, const std::vector<Unknown>& unknowns,
                               const std::string& tables = "") {
    std::string variables, equations;
    for (const Unknown& u : unknowns) {
        variables += u.name + " = { role = \"" + u.role + "\" }\n";
        equations += u.name + " = \"" + u.equation + "\"\n";
    }
    return "[system]\nname = \"" + name + "\"\n" + tables + "[variables]\n" + variables + "[equations]\n" +
           equations;
}

// z rises with the angular momentum of x, y, which is a constant.
inline const char* const particle = R"toml(
[system]
name = "particle"
[parameters]
omega = { positive = true }
[variables]
x = { role = "fast", weight = 0 }
y = { role = "fast", weight = 0 }
z = { role = "drift" }
[equations]
x = "x'' + omega^2*x = 0"
y = "y'' + omega^2*y = 0"
z = "z' = eps*(x'*y - y'*x)"
)toml";

} // namespace resonform::test
