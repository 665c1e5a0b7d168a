// SPDX-License-Identifier: GPL-3.0-or-later
// From a mechanism to its equations, line by line, to be followed beside a paper.
#pragma once

#include <string>
#include <vector>

namespace resonform {

struct DerivationSection {
    std::string heading;
    std::vector<std::string> equations; // in the notation of the file: "z'' = eps*y*x'' - eps*x*y''"
};

struct Derivation {
    std::vector<DerivationSection> constraints, accelerations;
    std::vector<std::string> remarks;   // on the constraints
    std::vector<std::string> agreement; // of the equations with those of another route
};

} // namespace resonform
