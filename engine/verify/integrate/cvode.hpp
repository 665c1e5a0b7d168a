// SPDX-License-Identifier: GPL-3.0-or-later
// SUNDIALS CVODE (Adams with fixed-point iteration, BDF with Newton's) and ARKODE (explicit Runge-Kutta of
// order 8, singly diagonally implicit of order 5 with Newton's). Newton's matrix is dense, the Jacobian that
// of the right-hand side if it has one, else by differences.
#pragma once

#include "verify/integrate/integrator.hpp"

namespace resonform {

// Dense output by the library's interpolation inside each step, which in ARKODE is of degree 5. The library's
// messages become `failure`, as do more steps than anybody would wait for.
std::unique_ptr<Integrator> make_cvode(Method method, RightHandSide rates, const Start& start);
std::unique_ptr<Integrator> make_arkode(Method method, RightHandSide rates, const Start& start);

} // namespace resonform
