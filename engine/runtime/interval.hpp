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
    Interval(const Interval&) = default;
    Interval& operator=(const Interval&) = default;
    ~Interval() = default;
    // What has been moved from answers for no time: its evaluator has no tables any more.
    Interval(Interval&& other) noexcept : Interval(static_cast<const Interval&>(other)) {
        other.end_ = Real(-1);
    }
    Interval& operator=(Interval&& other) noexcept {
        *this = static_cast<const Interval&>(other);
        if (this != &other) other.end_ = Real(-1);
        return *this;
    }
    // Precondition: check(eps, end) finds nothing.
    Interval(const Real& eps, const Real& end)
        : eps_(eps), end_(end + Real(4) * math::epsilon<Real>() * end), reach_(end_) {}

    // eps and end are numbers > 0, and end is moderate enough to be divided into panels.
    static Cause check(const Real& eps, const Real& end) {
        if (!(eps > Real(0) && math::finite(eps))) return {Status::bad_argument, "eps"};
        if (!(end > Real(1e-250) && end < Real(1e250))) return {Status::bad_argument, "slow_time_end"};
        return {};
    }

    // A quadrature was tabulated on [0, reach] only, and `built` says why. What lies beyond has that status;
    // ok, unless this is everything.
    Cause shorten(const Cause& built, const Real& reach) {
        if (built.status == Status::ok) return {};
        reach_ = reach;
        beyond_ = built;
        return reach > Real(0) ? Cause{} : built;
    }

    // What is behind the status of a point: the time, or where the domain ends before. `conditions`: what
    // must be positive at every time besides; `results`: what may overflow.
    const char* why(Status status, const char* conditions, const char* results) const noexcept {
        switch (status) {
        case Status::outside_interval: return beyond_.status == status ? beyond_.quantity : "t";
        case Status::bad_argument: return "t";
        case Status::outside_domain: return beyond_.status == status ? beyond_.quantity : conditions;
        case Status::overflow: return beyond_.status == status ? beyond_.quantity : results;
        default: return "";
        }
    }

    // T = eps t; a product that rounding carries just beyond the end is still within.
    Status locate(const Real& t, Real& T) const noexcept {
        if (!math::finite(t)) return Status::bad_argument;
        T = eps_ * t;
        if (t < Real(0) || end_ < T) return Status::outside_interval;
        return reach_ < T ? beyond_.status : Status::ok;
    }

    // The last slow time that is answered.
    [[nodiscard]] const Real& reach() const noexcept { return reach_; }

private:
    Real eps_{}, end_{}, reach_{};
    Cause beyond_;
};

} // namespace resonform

#endif
