// SPDX-License-Identifier: GPL-3.0-or-later
// From the coordinates of a mechanism to the variables of its system: (14) phi = psi + atan(xi/r), and the
// constants of the constraints in place of dependent coordinates.
#pragma once

#include "model/mechanics/integrals.hpp"

namespace resonform {

class ChangeOfVariables {
public:
    // A change may hold constants of the constraints; equations for their rates are solved then.
    // Errors: bad_input: as many new variables as changed coordinates are wanted; a change that is not
    // invertible, or depends on the coordinate that it replaces; refused: one that is not proved invertible.
    ChangeOfVariables(const Motion& motion, const SolvedConstraints& constraints,
                      const std::vector<Constant>& constants);

    // The variable that stands for an independent coordinate, by its place there.
    [[nodiscard]] const Coordinate& variable(std::size_t independent) const {
        return variables_[independent];
    }
    // R' of a constant, in the new variables.
    [[nodiscard]] const GiNaC::ex& rate(std::size_t constant) const { return rates_[constant]; }
    // An expression in the old coordinates, free of dependent velocities and accelerations, in the new ones.
    [[nodiscard]] GiNaC::ex operator()(const GiNaC::ex& e) const;
    // Where the expansion is made: eps = 0, small variables at the origin, velocities zero.
    [[nodiscard]] GiNaC::ex at_origin(const GiNaC::ex& e) const;

private:
    void choose_variables();
    void find_positions(const std::vector<Constant>& constants);
    [[noreturn]] void in_a_circle(const GiNaC::exmap& values) const;
    void require_invertible() const;
    void find_rates(const std::vector<Constant>& constants);

    const Motion& motion_;
    const SolvedConstraints& constraints_;
    std::vector<Coordinate> variables_;
    GiNaC::exmap positions_; // old coordinates that are not variables
    GiNaC::exmap all_;       // these, their velocities and accelerations
    std::vector<GiNaC::ex> rates_;
    GiNaC::exmap constants_; // R', R''
};

} // namespace resonform
