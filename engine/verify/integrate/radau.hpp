// SPDX-License-Identifier: GPL-3.0-or-later
// The collocation method Radau IIA with s stages, computed in the real type itself.
//
//   Y_i = y + h sum_j a_ij f(Y_j),   a_ij = int_0^{c_i} l_j,   c_s = 1,   y(t + h) = Y_s
//
// The nodes c_i = (1 + x_i)/2 are the zeros of P_{s-1} - P_s (Legendre), l_j the Lagrange polynomials on
// them. The rule is exact through degree 2s - 2, so that l_j has the Legendre coefficients
// (2k+1)/2 w_j P_k(x_j), and integrals of l_j follow from int P_k = (P_{k+1} - P_{k-1})/(2k+1).
// (E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, sections IV.5 and IV.8.)
#pragma once

#include <cstddef>
#include <vector>

namespace resonform {

// Defined for double, Float128, DoubleDouble. Matrices row by row.
template <class Real> struct RadauRule {
    explicit RadauRule(int stages); // >= 2

    std::size_t stages;
    std::vector<Real> nodes;  // c_i, ascending
    std::vector<Real> matrix; // a_ij
    // The collocation polynomial through increments Z_j = Y_j - y at the nodes and 0 at the start of the step
    // is theta sum_k q_k P_k(2 theta - 1); q_k = sum_j spectrum_kj Z_j.
    std::vector<Real> spectrum;
};

// P_0(x) ... P_{count-1}(x)
template <class Real> std::vector<Real> legendre(const Real& x, std::size_t count);

} // namespace resonform
