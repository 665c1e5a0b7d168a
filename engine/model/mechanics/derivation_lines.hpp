// SPDX-License-Identifier: GPL-3.0-or-later
// The lines that are printed between a mechanism and its equations.
#pragma once

#include "model/mechanics/equation_texts.hpp"
#include "model/mechanics/integrals.hpp"
#include "model/mechanics/mechanical_equations.hpp"
#include "model/mechanics/quasi_velocities.hpp"

#include <optional>

namespace resonform {

// The steps of the derivation, for the time of a call.
struct MechanicalSteps {
    const Motion& motion;
    const SolvedConstraints& constraints;
    const std::vector<Constant>& constants;
    const AppellEquations& appell;
    const std::optional<QuasiEquations>& quasi;
    EquationTexts& texts;
};

Derivation derivation_of(const MechanicalSteps& steps,
                         const std::vector<MechanicalEquations::Former>& formers);

} // namespace resonform
