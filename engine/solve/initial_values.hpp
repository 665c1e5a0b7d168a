// SPDX-License-Identifier: GPL-3.0-or-later
// Physical start values -> constants of the solution, through the inverse map at its full weight M:
//
//   z_0 = psi_0 - i psi'_0/omega(xi_0),   w_0 = z_0 + g(z_0, zbar_0, eps; xi_0),   Z_0 = X_0 + m(z_0, ...)
//   w_0 = eps C E(xi_0) F(xi_0; C) e^{i theta_0}    ->  C, theta_0
//   C_X = Z_0 - (closed primitives of z_X at xi_0)
//
// (design 2.5). This is data for an evaluator, which computes, in this order,
//
//   1. w_real, w_imaginary from the start values;
//   2. theta_0 = atan2(w_imaginary, w_real),  R = hypot(w_real, w_imaginary);
//   3. C = R/leading_scale; if `implicit`, repeats C <- R/scale(C) until C no longer changes: the
//      contraction factor is O(eps), scale = leading_scale (1 + O(eps)); not converged after 60 steps
//      means that R lies outside the domain of the expansion;
//   4. C_X = drift[k], which may contain C.
#pragma once

#include "solve/solution.hpp"

#include <vector>

namespace resonform {

struct InitialValues {
    // The ring of the solution and behind it one real constant for every entry of Solution::state
    // ("psi_0", "psi'_0", "x_0"). In this ring the slow variable stands for its start value, slow time
    // is 0, and so is every quadrature; other primitives are evaluated at the start.
    RingPtr ring;
    // One for each of Solution::state, in its order: its value less GradedField::shift.
    std::vector<GeneratorId> start;

    // One oscillator; empty without.
    Polynomial w_real, w_imaginary; // in start values, eps, parameters, slow start, roots
    Polynomial leading_scale;       // eps E(xi_0): positive
    Polynomial scale;               // eps E(xi_0) F(xi_0; C)
    bool implicit = false;          // C occurs in scale

    std::vector<Polynomial> drift; // C_X, ..., one for each of Solution::drift
};

InitialValues initial_values(const Solution& solution);

} // namespace resonform
