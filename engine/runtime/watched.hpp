// SPDX-License-Identifier: MIT
// A number that notes when a step of its computation is not of a size between 2^-300 and 2^300: as long as
// none is, every operation is that of Scaled (runtime/scaled.hpp) to the last bit, at a tenth of its price.
//
//   in double, K = 1e8:   K^40 / K^41  ->  left_range   K^2 / K^3  ->  1e-8
#ifndef RESONFORM_RUNTIME_WATCHED
#define RESONFORM_RUNTIME_WATCHED

#include "runtime/math.hpp"

#include <bit>
#include <limits>
#include <type_traits>

namespace resonform {

template <class Number> struct Watched {
    Number value{};
    long left = 0; // < 0: a step has left the range

    Watched() = default;
    template <class Other> [[gnu::always_inline]] explicit Watched(const Other& x) : value(Number(x)) {
        left = beyond(value);
    }
    [[gnu::always_inline]] Watched(const Number& x, long before) : value(x), left(before) {}

    [[gnu::always_inline]] friend Watched operator-(const Watched& a) { return {Number(-a.value), a.left}; }
    [[gnu::always_inline]] friend Watched operator+(const Watched& a, const Watched& b) {
        return {Number(a.value + b.value), a.left | b.left};
    }
    [[gnu::always_inline]] friend Watched operator-(const Watched& a, const Watched& b) {
        return {Number(a.value - b.value), a.left | b.left};
    }
    [[gnu::always_inline]] friend Watched operator*(const Watched& a, const Watched& b) {
        const Number product = a.value * b.value;
        return {product, a.left | b.left | beyond(product)};
    }
    [[gnu::always_inline]] friend Watched operator/(const Watched& a, const Watched& b) {
        const Number quotient = a.value / b.value;
        return {quotient, a.left | b.left | beyond(quotient)};
    }
    [[gnu::always_inline]] static long beyond(const Number& x) {
        if constexpr (std::is_same_v<Number, double> && sizeof(long) == sizeof(double)) {
            const long size = std::bit_cast<long>(x) & std::numeric_limits<long>::max();
            constexpr long least = std::bit_cast<long>(0x1p-140), most = std::bit_cast<long>(0x1p140);
            return ((size - least) | (most - size)) & -long(size != 0);
        } else {
            return math::within(x, 0x1p140) ? 0 : -1;
        }
    }
    // Known to be so.
    friend bool operator>(const Watched& a, const Watched& b) {
        return (a.left | b.left) >= 0 && a.value > b.value;
    }
};

namespace math {
template <class Number> inline constexpr int digits<Watched<Number>> = digits<Number>;

template <class Number> Watched<Number> root(const Watched<Number>& x, int k) {
    return {root(x.value, k), x.left};
}
} // namespace math

template <class Number> Watched<Number> sqrt(const Watched<Number>& x) {
    using math::sqrt;
    return {Number(sqrt(x.value)), x.left};
}
template <class Number> Watched<Number> sin(const Watched<Number>& x) {
    using math::sin;
    return {Number(sin(x.value)), x.left};
}
template <class Number> Watched<Number> cos(const Watched<Number>& x) {
    using math::cos;
    return {Number(cos(x.value)), x.left};
}
template <class Number> Watched<Number> exp(const Watched<Number>& x) {
    using math::exp;
    return {Number(exp(x.value)), x.left};
}
template <class Number> Watched<Number> log(const Watched<Number>& x) {
    using math::log;
    return {Number(log(x.value)), x.left};
}
template <class Number> Watched<Number> asinh(const Watched<Number>& x) {
    using math::asinh;
    return {Number(asinh(x.value)), x.left};
}
template <class Number> Watched<Number> sinh(const Watched<Number>& x) {
    using math::sinh;
    return {Number(sinh(x.value)), x.left};
}
template <class Number> Watched<Number> erf(const Watched<Number>& x) {
    using math::erf;
    return {Number(erf(x.value)), x.left};
}
template <class Number> Watched<Number> hypot(const Watched<Number>& x, const Watched<Number>& y) {
    using math::hypot;
    return {Number(hypot(x.value, y.value)), x.left | y.left};
}
template <class Number> Watched<Number> atan2(const Watched<Number>& y, const Watched<Number>& x) {
    using math::atan2;
    return {Number(atan2(y.value, x.value)), x.left | y.left};
}

} // namespace resonform

#endif
