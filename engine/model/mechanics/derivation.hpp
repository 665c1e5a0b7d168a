// SPDX-License-Identifier: GPL-3.0-or-later
// From a mechanism to its equations, line by line, to be followed beside a paper; and what equations were
// before a change of variables.
#pragma once

#include <string>
#include <vector>

namespace resonform {

struct DerivationSection {
    std::string heading;
    std::vector<std::string> equations; // in the notation of the file: "z'' = eps*y*x'' - eps*x*y''"
};

struct EquationBefore {
    std::string variable, text;
};

struct Derivation {
    // Of a mechanism.
    std::vector<DerivationSection> constraints, accelerations;
    std::vector<std::string> remarks;   // on the constraints
    std::vector<std::string> agreement; // of the equations with those of another route
    // Of equations that [change] brings to other variables, as the file has them: phi, "phi'' + ... = 0".
    std::vector<EquationBefore> before;
    std::vector<EquationBefore> change; // phi, "psi + atan(xi/r)"

    [[nodiscard]] bool is_of_mechanism() const { return !accelerations.empty(); }
};

} // namespace resonform
