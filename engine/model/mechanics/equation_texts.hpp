// SPDX-License-Identifier: GPL-3.0-or-later
// Equations of motion, linear in accelerations, as texts of a file.
#pragma once

#include "model/exact/solution.hpp"
#include "model/system/mechanism.hpp"

#include <string>
#include <vector>

namespace resonform {

class EquationTexts {
public:
    // The referents outlive the texts.
    EquationTexts(const System& system, ExactForm& form, Place place)
        : system_(system), form_(form), place_(std::move(place)) {}

    // Residuals as they are if each holds its own acceleration only, else solved. If the solution is longer
    // than a text may be, the equations stay unsolved, and the reader of the file solves them. A residual
    // that would be too long when a change of variables is multiplied out stands as the change leaves it.
    std::vector<std::string> of(const std::vector<GiNaC::ex>& residuals,
                                const std::vector<Coordinate>& unknowns);
    // Divided by a number and by symbols declared nonzero, multiplied by a denominator that moves.
    [[nodiscard]] GiNaC::ex without_content(const GiNaC::ex& residual);

private:
    std::vector<std::string> of_exact(std::vector<GiNaC::ex> residuals,
                                      const std::vector<Coordinate>& unknowns);
    std::vector<std::string> solved(const std::vector<ExactRow>& rows,
                                    const std::vector<Coordinate>& unknowns);
    // The coefficients of accelerations, and minus the rest.
    std::vector<ExactRow> rows_of(const std::vector<GiNaC::ex>& residuals,
                                  const std::vector<Coordinate>& unknowns);

    const System& system_;
    ExactForm& form_;
    Place place_;
};

} // namespace resonform
