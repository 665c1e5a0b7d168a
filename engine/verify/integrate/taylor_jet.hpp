// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor coefficients of the solution of u' = f(u) from a tape of f: coefficient n of every register
// from coefficients 0 ... n of its operands, then u_{n+1} = [f]_n/(n+1). Products are Cauchy sums;
// functions obey their differential equations, e.g. s = sin a, c = cos a:
//
//   n s_n = sum_{j=1}^n j a_j c_{n-j},     n c_n = -sum_{j=1}^n j a_j s_{n-j}
//
// (R. E. Moore, Interval Analysis, 1966, ch. 11.)
#pragma once

#include "verify/integrate/tape.hpp"

#include <cstddef>
#include <vector>

namespace resonform {

template <class Real> class TaylorJet {
public:
    // order >= 2
    TaylorJet(const BoundTape<Real>& tape, int order);

    // Coefficients 0 ... order of every state about the point `state`.
    void expand(const std::vector<Real>& state);

    [[nodiscard]] int order() const { return order_; }
    [[nodiscard]] const Real* coefficients(int state) const { return row(constants_ + state); }
    // sum_k c_k h^k
    [[nodiscard]] Real value(int state, const Real& h) const;

private:
    Real* row(int r) { return rows_.data() + static_cast<std::size_t>(r) * stride_; }
    [[nodiscard]] const Real* row(int r) const {
        return rows_.data() + static_cast<std::size_t>(r) * stride_;
    }
    void coefficient(const Tape::Instruction& step, int n);

    Tape tape_;
    std::vector<Real> values_; // a scratch copy of all registers, for coefficient 0
    int order_, constants_;
    std::size_t stride_;
    std::vector<Real> rows_; // [register][coefficient]
};

} // namespace resonform
