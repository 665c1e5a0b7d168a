// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets in modal coordinates. With z_a = row_a . u they are constants,
//   {z_a, z_b} = sum over pairs (q, p) of (row_a[q] row_b[p] - row_a[p] row_b[q]),
// and {z_a, z_b} (lambda_a + lambda_b) = 0: a coordinate has a bracket with those of the opposite
// eigenvalue only, as z = q - i p and zbar = q + i p with {z, zbar} = 2 i.
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <map>
#include <vector>

namespace resonform {

// Errors: bad_input: the system has no energy; refused: variables that belong to no pair, coordinates with
// several partners (equal eigenvalues whose modes are not orthogonal), a bracket that is proved neither to
// vanish nor not to vanish.
std::vector<HamiltonianForm::Bracket> brackets_of_modes(const GradedField& field);

// {y_a, f} for every modal coordinate y_a. (On the left of f: x' = {x, H}.)
class HamiltonianVector {
public:
    using Brackets = std::vector<HamiltonianForm::Bracket>;
    HamiltonianVector(const Ring& ring, const Brackets& brackets, const Polynomial& f);

    [[nodiscard]] const Polynomial& at(GeneratorId coordinate) const { return components_.at(coordinate); }

private:
    std::map<GeneratorId, Polynomial> components_;
};

} // namespace resonform
