// SPDX-License-Identifier: GPL-3.0-or-later
// How far back the parts of a node of a SeriesProgram are read, so that a run can give back the others.
//
//   s = sine(u); f = product(constant c of weights 0 and 1, s); g = sum(f, u), asked for weight by weight:
//   u and s are read from the first weight on (by the recurrence), f and g at the current weight only
//
// Weight 0 is read always (BasicSeriesRun::correct) and not counted here.
#pragma once

#include "algebra/series/series_program.hpp"

#include <limits>
#include <vector>

namespace resonform {

inline constexpr int whole_history = std::numeric_limits<int>::max();

// By node: at weight n it is read at n - history ... n.
std::vector<int> histories(const SeriesProgram& program);

} // namespace resonform
