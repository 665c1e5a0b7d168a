// SPDX-License-Identifier: GPL-3.0-or-later
// Equations, linear in their highest derivatives, as texts of a file.
#pragma once

#include "model/exact/solution.hpp"

#include <string>
#include <vector>

namespace resonform {

class EquationTexts {
public:
    // The referents outlive the texts.
    EquationTexts(const System& system, ExactForm& form, Place place)
        : system_(system), form_(form), place_(std::move(place)) {}

    // Residuals as they are if each holds its own unknown, a highest derivative, only, else solved. If the
    // solution is longer than a text may be, the equations stay unsolved, and the reader of the file solves
    // them. A residual that would be too long when a change of variables is multiplied out stands as the
    // change leaves it.
    std::vector<std::string> of(const std::vector<GiNaC::ex>& residuals,
                                const std::vector<GiNaC::symbol>& unknowns);
    // "x'' = rate" for each; empty unless each residual is its own unknown, or minus it, and a rate that
    // holds no unknown, and the rates are short enough for exact form.
    std::vector<std::string> rates_of(const std::vector<GiNaC::ex>& residuals,
                                      const std::vector<GiNaC::symbol>& unknowns);
    // Divided by a number and by symbols declared nonzero, multiplied by a denominator that moves.
    [[nodiscard]] GiNaC::ex without_content(const GiNaC::ex& residual);

private:
    std::vector<std::string> of_exact(std::vector<GiNaC::ex> residuals,
                                      const std::vector<GiNaC::symbol>& unknowns);
    std::vector<std::string> solved(const std::vector<ExactRow>& rows,
                                    const std::vector<GiNaC::symbol>& unknowns);
    // The coefficients of the unknowns, and minus the rest.
    std::vector<ExactRow> rows_of(const std::vector<GiNaC::ex>& residuals,
                                  const std::vector<GiNaC::symbol>& unknowns);

    const System& system_;
    ExactForm& form_;
    Place place_;
};

} // namespace resonform
