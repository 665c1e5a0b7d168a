// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of a mechanism as those of an ordinary system, as texts.
#pragma once

#include "model/mechanics/derivation.hpp"
#include "model/system/mechanism.hpp"

namespace resonform {

struct MechanicalEquations {
    struct Line {
        std::string variable, text;
        SourceText source;
    };
    std::vector<Line> equations; // of variables that move
    struct Former {              // constant at eps = 0
        Coordinate coordinate;
        std::string instead_of; // the coordinate that it replaces
        Role role;              // slow where something depends on it, else drift
        bool fixed = false;     // slow, and constant for every eps: a parameter of the equations
    };
    std::vector<Former> constants;
    Derivation derivation;
};

} // namespace resonform
