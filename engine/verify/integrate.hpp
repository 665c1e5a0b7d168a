// SPDX-License-Identifier: GPL-3.0-or-later
// Direct integration of the ORIGINAL first-order system: the judge of every formula.
#pragma once

#include "model/first_order_system.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

// The right-hand side as a tape of operations, with numbers put in for the parameters and eps.
class Tape; // verify/tape.hpp

struct IntegrationResult {
    std::vector<std::vector<double>> values; // [state][point]; double methods
    std::size_t steps = 0, evaluations = 0;
    double seconds = 0;
    std::string failure; // empty if the method reached the end
};

// Taylor-series integrator in Real = double, long double, __float128 (and dd_real if it serves).
// values[state][point] at the given ascending times; tolerance is relative to each state's scale.
template <class Real> struct TaylorResult {
    std::vector<std::vector<Real>> values;
    std::size_t steps = 0;
    double seconds = 0;
    std::string failure;
};
template <class Real>
TaylorResult<Real> integrate_taylor(const FirstOrderSystem& system, const std::vector<Real>& parameters,
                                    Real eps, const std::vector<Real>& start, const std::vector<Real>& times,
                                    Real tolerance, int order = 0);

} // namespace resonform
