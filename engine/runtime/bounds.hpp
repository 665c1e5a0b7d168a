// SPDX-License-Identifier: MIT
// Bounds of what a function takes on over an interval, from one evaluation: a number that stands for all
// between two others.
//
//   Bounds<double> x(0, 2);  x * x + 1   ->   1 ... 5        x - x   ->   -2 ... 2, too wide: not the same x
//
// Sums and products are rounded to nearest, so a bound may be wrong by last places. Where a function is not
// defined on all of it, one of the two is not a number, and stays so in all that is made of it.
#ifndef RESONFORM_RUNTIME_BOUNDS
#define RESONFORM_RUNTIME_BOUNDS

#include "runtime/math.hpp"

#include <type_traits>

namespace resonform {

// a, unless b is less or more; so it is no number, if a is none.
template <class Real> [[gnu::always_inline]] inline Real lesser(const Real& a, const Real& b) {
    if constexpr (requires { smaller(a, b); })
        return smaller(a, b); // lane by lane
    else
        return b < a ? b : a;
}

template <class Answer, class Real>
[[gnu::always_inline]] inline Real chosen(const Answer& where, const Real& a, const Real& b) {
    if constexpr (std::is_convertible_v<Answer, bool>)
        return where ? a : b;
    else
        return select(where, a, b);
}

template <class Real> class Bounds {
public:
    Bounds() = default;
    Bounds(const Real& x) : low_(x), high_(x) {} // NOLINT(google-explicit-constructor): beside constants
    Bounds(const Real& low, const Real& high) : low_(low), high_(high) {}
    template <class Number>
    requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, Real>) explicit Bounds(Number x)
        : Bounds(Real(x)) {}

    // Lane by lane, where Real is several side by side.
    [[nodiscard]] auto is_positive() const { return (Real(0) < low_) & (high_ == high_); }

    friend Bounds operator-(const Bounds& a) { return {-a.high_, -a.low_}; }
    friend Bounds operator+(const Bounds& a, const Bounds& b) { return {a.low_ + b.low_, a.high_ + b.high_}; }
    friend Bounds operator-(const Bounds& a, const Bounds& b) { return {a.low_ - b.high_, a.high_ - b.low_}; }
    friend Bounds operator*(const Real& a, const Bounds& b) {
        const Real one = a * b.low_, other = a * b.high_;
        return {lesser(one, other), math::larger(other, one)};
    }
    friend Bounds operator*(const Bounds& a, const Real& b) { return b * a; }
    friend Bounds operator*(const Bounds& a, const Bounds& b) {
        if (&a == &b) return square(a);
        const Real ll = a.low_ * b.low_, hh = a.high_ * b.high_, lh = a.low_ * b.high_, hl = a.high_ * b.low_;
        return {lesser(lesser(ll, hh), lesser(lh, hl)),
                math::larger(math::larger(hh, ll), math::larger(lh, hl))};
    }
    friend Bounds operator/(const Bounds& a, const Bounds& b) { return a * per(b); }
    friend Bounds magnitude(const Bounds& a) {
        return {math::larger(math::larger(a.low_, Real(-a.high_)), Real(0)),
                math::larger(a.high_, Real(-a.low_))};
    }
    friend Bounds per(const Bounds& a) {
        const auto known = (Real(0) < a.low_) | (a.high_ < Real(0));
        return {chosen(known, math::per(a.high_), math::not_a_number<Real>()), math::per(a.low_)};
    }
    friend Bounds sqrt(const Bounds& a) {
        using math::sqrt;
        return {sqrt(a.low_), sqrt(a.high_)};
    }
    friend Bounds exp(const Bounds& a) {
        using math::exp;
        return {exp(a.low_), exp(a.high_)};
    }
    // Of any turn.
    friend Bounds cos(const Bounds& a) {
        return {(a.low_ - a.low_) - Real(1), (a.high_ - a.high_) + Real(1)};
    }
    friend Bounds sin(const Bounds& a) { return cos(a); }
    friend Bounds hypot(const Bounds& a, const Bounds& b) { return sqrt(square(a) + square(b)); }

private:
    static Bounds square(const Bounds& a) {
        const Bounds size = magnitude(a);
        return {size.low_ * size.low_, size.high_ * size.high_};
    }

    Real low_{}, high_{};
};

} // namespace resonform

#endif
