// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the orders 1 ... N + 1 is the most accurate at a given eps: the series are asymptotic, and beyond
// some order their terms grow. With y[n] the outputs at order n, normal form and map through the weight that
// the count asks for there,
//
//   d_n = max |y[n + 1] - y[n]|                          n = 1 ... N
//   d_n = Q n(n - 1)/(N(N - 1)) d_{n - 2}                n = N + 1, N + 2
//   error of order n = max(d_n, d_{n + 1}),              Q = max(d_N/d_{N - 2}, d_{N - 1}/d_{N - 3})
//
// and the best is the order of the least error, of equal ones the lowest. Terms of asymptotic series grow as
// n!. Two terms make an error, and quotients go over two orders, because a symmetry can make every other term
// small, or 0: of d_{n + 1} = 0 the next that is not 0 counts, and where the last ones are 0 they are
// continued as those beyond N. Where Q is not known d_n/n! goes on by its last quotient, and d_n by eps where
// it is alone. The terms beyond N are an extrapolation, and so is the answer. With weights in multiples of
// 1/eps_root orders are counted in these, and eps^(1/eps_root) stands for eps.
#pragma once

#include "verify/estimate/error_estimator.hpp"
#include "verify/evaluate/interpretation.hpp"

#include <memory>
#include <vector>

namespace resonform {

struct BestOrder {
    Rational eps;
    int order = 0;       // 0: all terms vanish or are not known
    double accuracy = 0; // the error that is expected of it
    int looked_at = 0;   // N + 1
};

// From d_1 ... d_N at one eps, not negative; where a term is not finite, the error of its order is not known.
BestOrder best_of(const Rational& eps, const std::vector<double>& terms, int eps_root = 1);

class OrderSeries {
public:
    // next: a solution of order N + 1 of the system of `fixed`, a scene with the values of [fix] put in whose
    // order is N. An order that cannot be solved has no numbers. Formulas that the estimator of the scene has
    // made are not made twice.
    OrderSeries(const Scene& fixed, const Solution& next, const ErrorEstimator& made);

    // d_1 ... d_N of each output, in the scene's order: 0 where it is not above `rounding` of that output,
    // infinite where a formula has no numbers.
    [[nodiscard]] std::vector<std::vector<double>> terms(long double eps, long double slow_time_end,
                                                         const std::vector<double>& times,
                                                         const std::vector<double>& rounding) const;

private:
    std::vector<std::shared_ptr<const Interpretation>> formulas_; // of order 1 ... N + 1; null: none
    std::size_t outputs_;
};

} // namespace resonform
