// SPDX-License-Identifier: GPL-3.0-or-later
// Data of a scene as emitted code evaluates them.
#pragma once

#include "algebra/number/piecewise_polynomial.hpp"
#include "runtime/pieces.hpp"
#include "runtime/spline.hpp"

#include <cstddef>
#include <vector>

namespace resonform {

// It must not outlive the data.
inline Spline spline_of(const PiecewisePolynomial& data) {
    return {data.breakpoints.data(), data.coefficients.data(), data.pieces(), data.degree};
}

// Appends the slow times at which the pieces of `data` end. argument(T) is the value of its slow variable at
// slow time T, linear in T.
template <class Number, class Argument>
void append_edges(const PiecewisePolynomial& data, const Argument& argument, std::vector<Number>& edges) {
    const Number at_0 = argument(0), at_1 = argument(1);
    std::size_t next = edges.size();
    edges.resize(next + data.breakpoints.size());
    add_edges(spline_of(data), at_0, at_1, edges, next);
}

} // namespace resonform
