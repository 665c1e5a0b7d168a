// SPDX-License-Identifier: GPL-3.0-or-later
// Is a change of variables x_i = f_i(X_1, ..., X_n) invertible?
#pragma once

#include "model/exact/form.hpp"

#include <vector>

namespace resonform {

// det(df_i/dX_j), of as many values as variables.
GiNaC::ex determinant_of_slopes(const std::vector<GiNaC::ex>& values,
                                const std::vector<GiNaC::symbol>& variables);

// Errors: bad_input: the determinant, where the equations are expanded, is zero; refused: this is not known,
// and no declaration in `domain` tells it.
void require_invertible(const GiNaC::ex& determinant_there, ExactForm& form, const System& domain,
                        const Place& place);

} // namespace resonform
