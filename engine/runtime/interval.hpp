// SPDX-License-Identifier: MIT
// The times an evaluator answers for: t >= 0 with slow time T = eps t within [0, end].
#pragma once

#include "runtime/math.hpp"
#include "runtime/status.hpp"

namespace resonform {

template <class Real> class Interval {
public:
    Interval() = default;
    // Precondition: accepts(eps, end).
    Interval(const Real& eps, const Real& end)
        : eps_(eps), end_(end + Real(4) * math::epsilon<Real>() * end) {}

    // eps and end are numbers > 0, and end is moderate enough to be divided into panels.
    static bool accepts(const Real& eps, const Real& end) {
        return eps > Real(0) && math::finite(eps) && end > Real(1e-250) && end < Real(1e250);
    }

    // T = eps t; a product that rounding carries just beyond the end is still within.
    Status locate(const Real& t, Real& T) const noexcept {
        if (!math::finite(t)) return Status::bad_argument;
        T = eps_ * t;
        return t < Real(0) || end_ < T ? Status::outside_interval : Status::ok;
    }

private:
    Real eps_{}, end_{};
};

} // namespace resonform
