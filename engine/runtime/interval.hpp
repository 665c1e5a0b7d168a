// SPDX-License-Identifier: MIT
// The times an evaluator answers for: t >= 0 with slow time T = eps t within [0, end], and within the domain
// where that ends before.
#ifndef RESONFORM_RUNTIME_INTERVAL
#define RESONFORM_RUNTIME_INTERVAL

#include "runtime/math.hpp"
#include "runtime/status.hpp"

namespace resonform {

template <class Real> class Interval {
public:
    Interval() = default;
    // Precondition: accepts(eps, end).
    Interval(const Real& eps, const Real& end)
        : eps_(eps), end_(end + Real(4) * math::epsilon<Real>() * end), reach_(end_) {}

    // eps and end are numbers > 0, and end is moderate enough to be divided into panels.
    static bool accepts(const Real& eps, const Real& end) {
        return eps > Real(0) && math::finite(eps) && end > Real(1e-250) && end < Real(1e250);
    }

    // A quadrature was tabulated on [0, reach] only, and `built` says why. What lies beyond has that status;
    // ok, unless this is everything.
    Status shorten(Status built, const Real& reach) {
        if (built == Status::ok) return built;
        reach_ = reach;
        beyond_ = built;
        return reach > Real(0) ? Status::ok : built;
    }

    // T = eps t; a product that rounding carries just beyond the end is still within.
    Status locate(const Real& t, Real& T) const noexcept {
        if (!math::finite(t)) return Status::bad_argument;
        T = eps_ * t;
        if (t < Real(0) || end_ < T) return Status::outside_interval;
        return reach_ < T ? beyond_ : Status::ok;
    }

private:
    Real eps_{}, end_{}, reach_{};
    Status beyond_ = Status::outside_domain;
};

} // namespace resonform

#endif
