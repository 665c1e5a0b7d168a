// SPDX-License-Identifier: GPL-3.0-or-later
// The spline of odd degree d through samples, with not-a-knot ends: d - 1 times differentiable at all samples
// but the first and the last (d + 1)/2, where it is one polynomial.
//
//   S(x_i) = y_i,   i = 1 ... n,   of the n B-splines over the knots x_1 (d + 1 times), x_{(d+3)/2} ...
//                                  x_{n-(d+1)/2}, x_n (d + 1 times)
//
// (C. de Boor, A Practical Guide to Splines, 2001, ch. XIII.) Solved in 50 digits, so that every compiler
// rounds to the same coefficients.
#pragma once

#include "algebra/number/piecewise_polynomial.hpp"

#include <vector>

namespace resonform {

// Precondition: x ascends, degree is odd, at least degree + 1 points.
PiecewisePolynomial spline_through(const std::vector<double>& x, const std::vector<double>& y, int degree);

} // namespace resonform
