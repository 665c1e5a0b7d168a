// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations between exact forms.
#pragma once

#include "model/exact/form.hpp"

#include <vector>

namespace resonform {

// a_1 x_1 + ... + a_n x_n = b, written { a_1, ..., a_n, b }.
using ExactRow = std::vector<GiNaC::ex>;

// Errors (refused): a determinant that is not seen to differ from zero.
std::vector<GiNaC::ex> solve_exactly(std::vector<ExactRow> rows, ExactForm& form, const Place& place);

// The same; empty if the solution may have more terms than an expression of a file. This is estimated from
// the terms of the entries, without computing the solution.
std::vector<GiNaC::ex> solve_if_short(std::vector<ExactRow> rows, ExactForm& form, const Place& place);

} // namespace resonform
