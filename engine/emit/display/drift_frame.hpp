// SPDX-License-Identifier: GPL-3.0-or-later
// The drift variables minus the known part of their motion: X = x - r*log(...), as in (19).
#pragma once

#include "emit/display/page.hpp"
#include "expand/expansion/graded_field.hpp"
#include "solve/solution.hpp"

#include <string>
#include <vector>

namespace resonform {

// One drift variable of the field and the names under which its motion is printed.
struct DriftFrame {
    std::string variable; // x
    std::string name;     // X where the known drift is removed, else x
    std::string normal;   // z_X: the same in the normal form
    bool removed = false;
    DisplaySum primitive; // of the removed rate
};

// In the order of field.drift. Removed is the weight-1 rate of the normal form, where it is not zero
// and a solution (may be null) gives its primitive.
std::vector<DriftFrame> drift_frames(const GradedField& field, const Solution* solution);

// X = x - primitive, where it is removed.
void define_frame(Section& section, const DriftFrame& frame);

// The terms of a rate but those of weight 1 in eps alone.
Polynomial without_known_drift(const Ring& ring, GeneratorId eps, const Polynomial& rate);

} // namespace resonform
