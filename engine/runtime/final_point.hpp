// SPDX-License-Identifier: MIT
// What an evaluator knows at one time, as its tables would say it: columns, cosines and sines of phases,
// powers of e, and where the domain ends before (runtime/final_sums.hpp has the integrals).
#ifndef RESONFORM_RUNTIME_FINAL_POINT
#define RESONFORM_RUNTIME_FINAL_POINT

#include "runtime/decay.hpp"
#include "runtime/final_sums.hpp"
#include "runtime/layer.hpp"
#include "runtime/phase.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace resonform {

// Phases up to this are summed in QuickNumber.
inline constexpr double quick_radians = 2048;

// cos theta and sin theta, theta reduced to one turn before it is rounded.
template <class Real, class Number> void turn(const Number& theta, Real& cosine, Real& sine) {
    using math::cos;
    using math::floor;
    using math::sin;
    Real angle, rest = Real(0);
    if constexpr (std::is_same_v<Number, Twice<Real>>) {
        const Number full = Number(2) * math::pi<Number>();
        Number turns = theta / full;
        for (int step = 0; step < 2; ++step) // of more turns than Real can count the second takes the rest
            turns = turns - Number(floor(Real(turns.high + Real(1) / Real(2))));
        const Number product = Number::product(turns.high, full.high);
        angle = product.high;
        rest = product.low + (turns.high * full.low + turns.low * full.high);
    } else if constexpr (std::is_same_v<Number, Real>) {
        const Real full = Real(2) * math::pi<Real>(), turns = theta / full;
        angle = (turns - floor(Real(turns + Real(1) / Real(2)))) * full;
    } else { // whole * high is exact: 53 digits and 11
        constexpr double high = 6.283185307179586, low = 2.4492935982947064e-16;
        const Number whole(std::floor(static_cast<double>(theta) / high + 0.5));
        const Number part = (theta - whole * Number(high)) - whole * Number(low);
        angle = static_cast<Real>(part);
        rest = static_cast<Real>(part - Number(angle));
    }
    const Real c = cos(angle), s = sin(angle);
    cosine = c - s * rest;
    sine = s + c * rest;
}

template <class Real, class Course> class FinalPoint {
public:
    std::array<Real, Course::columns> tables{};
    std::array<Real, Course::angles> cosine{}, sine{}, power{};

    explicit FinalPoint(const Course& course) : course_(course) {}

    // bad_argument, outside_interval: of t, or a phase is not known to known_radians at t; overflow,
    // outside_domain: an evaluator ends before t. low_precision: as Phase.
    Status reach(const Real& eps, const Real& t) {
        if (!math::finite(t)) return Status::bad_argument;
        if (t < Real(0)) return Status::outside_interval;
        const Real T = eps * t;
        if (!(T < Real(1e250))) return Status::outside_interval;
        at_start_ = !(Real(0) < T);
        const Real least = Real(1e-250); // what holds at t = 0 holds there
        Real end = T < least ? least : T;
        if constexpr (requires { course_.margins(T); }) {
            if (!clear_of_doubt(course_, end)) {
                const auto margins = [this](const Real& x) { return course_.margins(x); };
                beyond_ = clear_of_layers(margins, Nameless{}, end, Course::samples).status;
                if (!(Real(0) < end)) return beyond_;
            }
        }
        using Quick = std::conditional_t<Course::angles == 0, Real, QuickNumber<Real>>;
        using Wide = std::conditional_t<Course::angles == 0, Real, WideNumber<Real>>;
        const auto whole = [&]<class Number>(const Number& product) {
            return beyond_ != Status::ok || T < least ? Number(end) : product;
        };
        const Status status = integrate(whole(wide_product<Quick>(eps, t)));
        if constexpr (!std::is_same_v<Quick, Wide>)
            if (too_long_) return integrate(whole(wide_product<Wide>(eps, t)));
        return status;
    }

private:
    template <class Number> Status integrate(const Number& end) {
        const typename Course::template Angles<Number> turning(course_);
        if (turning.lost.status != Status::ok) return turning.lost.status;
        FinalSums<Real, Course, Number> sums(course_, turning);
        if constexpr (!std::is_same_v<Number, WideNumber<Real>>) {
            too_long_ = Real(quick_radians) < sums.first_turn(end); // before anything is integrated
            if (too_long_) return Status::ok;
        }
        if (const Status status = sums.integrate(end); status != Status::ok) return status;
        if constexpr (!std::is_same_v<Number, WideNumber<Real>>) {
            too_long_ = !sums.turns_little();
            if (too_long_) return Status::ok;
        }
        tables = at_start_ ? course_.start() : sums.tables();
        Status status = Status::ok;
        const auto angle = [&](std::size_t k) {
            return at_start_ ? turning.start[k] : turning.start[k] + sums.angles()[k];
        };
        for (std::size_t k = 0; k < Course::angles; ++k)
            if (Course::decays[k]) power[k] = exponential<Real>(angle(k));
        for (std::size_t k = 0; k < Course::angles; ++k) {
            if (Course::decays[k] || all_faded(Course::fades[k], power)) continue;
            const Number theta = angle(k);
            const Real size = math::magnitude(static_cast<Real>(theta));
            if constexpr (!std::is_same_v<Number, WideNumber<Real>>) {
                too_long_ = !(size <= Real(quick_radians));
                if (too_long_) return Status::ok;
            }
            const int digits = Course::rounded[k] ? math::digits<Real> : math::digits<WideNumber<Real>>;
            const Real resolution = math::power(Real(Real(1) / Real(2)), digits - 1);
            if (!(size * resolution <= Real(known_radians))) return Status::outside_interval;
            if (!(size <= Real(1e14) && size * resolution <= Real(1e-9))) status = Status::low_precision;
            turn(theta, cosine[k], sine[k]);
        }
        return beyond_ == Status::ok ? status : beyond_;
    }

    const Course& course_;
    Status beyond_ = Status::ok;
    bool at_start_ = false, too_long_ = false;
};

} // namespace resonform

#endif
