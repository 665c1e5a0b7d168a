// SPDX-License-Identifier: MIT
// A number that notes when a step of its computation is not of a size between 2^-300 and 2^300: as long as
// none is, every operation is that of Scaled (runtime/scaled.hpp) to the last bit, at a tenth of its price.
//
//   in double, K = 1e8:   K^40 / K^41  ->  left_range   K^2 / K^3  ->  1e-8
#ifndef RESONFORM_RUNTIME_WATCHED
#define RESONFORM_RUNTIME_WATCHED

#include "runtime/math.hpp"

namespace resonform {

template <class Number> struct Watched {
    Number value{};
    bool left_range = false;

    Watched() = default;
    template <class Other> explicit Watched(const Other& x) : Watched(Number(x), false) {}
    Watched(const Number& x, bool before) : value(x), left_range(bool(before | !math::within(x, 0x1p300))) {}

    static bool either(const Watched& a, const Watched& b) { return bool(a.left_range | b.left_range); }

    friend Watched operator-(const Watched& a) { return {Number(-a.value), a.left_range}; }
    friend Watched operator+(const Watched& a, const Watched& b) {
        return {Number(a.value + b.value), either(a, b)};
    }
    friend Watched operator-(const Watched& a, const Watched& b) {
        return {Number(a.value - b.value), either(a, b)};
    }
    friend Watched operator*(const Watched& a, const Watched& b) {
        return {Number(a.value * b.value), either(a, b)};
    }
    friend Watched operator/(const Watched& a, const Watched& b) {
        return {Number(a.value / b.value), either(a, b)};
    }
    // Known to be so.
    friend bool operator>(const Watched& a, const Watched& b) {
        return !a.left_range && !b.left_range && a.value > b.value;
    }
};

namespace math {
template <class Number> inline constexpr int digits<Watched<Number>> = digits<Number>;

template <class Number> Watched<Number> root(const Watched<Number>& x, int k) {
    return {root(x.value, k), x.left_range};
}
} // namespace math

template <class Number> Watched<Number> sqrt(const Watched<Number>& x) {
    using math::sqrt;
    return {Number(sqrt(x.value)), x.left_range};
}
template <class Number> Watched<Number> sin(const Watched<Number>& x) {
    using math::sin;
    return {Number(sin(x.value)), x.left_range};
}
template <class Number> Watched<Number> cos(const Watched<Number>& x) {
    using math::cos;
    return {Number(cos(x.value)), x.left_range};
}
template <class Number> Watched<Number> exp(const Watched<Number>& x) {
    using math::exp;
    return {Number(exp(x.value)), x.left_range};
}
template <class Number> Watched<Number> log(const Watched<Number>& x) {
    using math::log;
    return {Number(log(x.value)), x.left_range};
}
template <class Number> Watched<Number> asinh(const Watched<Number>& x) {
    using math::asinh;
    return {Number(asinh(x.value)), x.left_range};
}
template <class Number> Watched<Number> sinh(const Watched<Number>& x) {
    using math::sinh;
    return {Number(sinh(x.value)), x.left_range};
}
template <class Number> Watched<Number> erf(const Watched<Number>& x) {
    using math::erf;
    return {Number(erf(x.value)), x.left_range};
}
template <class Number> Watched<Number> hypot(const Watched<Number>& x, const Watched<Number>& y) {
    using math::hypot;
    return {Number(hypot(x.value, y.value)), Watched<Number>::either(x, y)};
}
template <class Number> Watched<Number> atan2(const Watched<Number>& y, const Watched<Number>& x) {
    using math::atan2;
    return {Number(atan2(y.value, x.value)), Watched<Number>::either(x, y)};
}

} // namespace resonform

#endif
