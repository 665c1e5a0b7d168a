// SPDX-License-Identifier: MIT
// Packs of twice the digits of double.
#ifndef RESONFORM_RUNTIME_PACK_PAIR
#define RESONFORM_RUNTIME_PACK_PAIR

#include "runtime/pack.hpp"

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

// high + low: twice the digits but a few, |low| about a unit of the last place of high.
struct PackPair {
    Pack high, low;

    PackPair() = default;
    PackPair(const Pack& h, const Pack& l) : high(h), low(l) {}
    explicit PackPair(const Pack& x) : high(x), low(0) {}
    explicit PackPair(const Twice<double>& x) : high(x.high), low(x.low) {}
    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit PackPair(Number x) : high(x), low(0) {}
    explicit operator Pack() const { return high + low; }

    static PackPair product(const Pack& a, const Pack& b) {
        using L = Pack::L;
        const Pack p = Pack::of([](auto x, auto y) { return L::product(x, y); }, a, b);
        return {p, Pack::of([](auto x, auto y, auto z) { return L::product_error(x, y, z); }, a, b, p)};
    }
    // |b| below |a|
    static PackPair sorted_sum(const Pack& a, const Pack& b) {
        const Pack s = a + b;
        return {s, b - (s - a)};
    }
    friend PackPair operator-(const PackPair& a) { return {-a.high, -a.low}; }
    friend PackPair operator+(const PackPair& a, const PackPair& b) {
        const Pack s = a.high + b.high, part = s - a.high;
        const Pack rest = (a.high - (s - part)) + (b.high - part);
        return sorted_sum(s, rest + (a.low + b.low));
    }
    friend PackPair operator-(const PackPair& a, const PackPair& b) { return a + (-b); }
    friend PackPair operator*(const PackPair& a, const PackPair& b) {
        const PackPair p = product(a.high, b.high);
        return sorted_sum(p.high, a.high * b.low + (a.low * b.high + p.low));
    }
    // c - a b, where that is small
    static Pack rest(const Pack& a, const Pack& b, const Pack& c) {
#if defined(__FMA__)
        return Pack::of([](auto x, auto y, auto z) { return Pack::L::multiply_add(-x, y, z); }, a, b, c);
#else
        const PackPair p = product(a, b);
        return (c - p.high) - p.low;
#endif
    }
    // sum + a b; `low` may grow to a few units of the last place of `high`.
    friend PackPair added_product(const PackPair& sum, const PackPair& a, const PackPair& b) {
        const PackPair p = product(a.high, b.high);
        const Pack s = sum.high + p.high, part = s - sum.high;
        const Pack rest = (sum.high - (s - part)) + (p.high - part);
        return {s, (rest + sum.low) + (a.high * b.low + (a.low * b.high + p.low))};
    }
    friend PackPair operator/(const PackPair& a, const PackPair& b) {
        const Pack inverse = reciprocal(b.high), q = a.high * inverse;
        return sorted_sum(q, (rest(q, b.high, a.high) + (a.low - q * b.low)) * inverse);
    }
    friend Mask operator<(const PackPair& a, const PackPair& b) { return (a - b).high < Pack(0); }
    friend Mask operator>(const PackPair& a, const PackPair& b) { return b < a; }
    friend Mask operator==(const PackPair& a, const PackPair& b) {
        return (a.high == b.high) & (a.low == b.low);
    }
};

inline PackPair reciprocal(const PackPair& x) {
    const Pack inverse = reciprocal(x.high);
    const Pack rest = PackPair::rest(x.high, inverse, Pack(1)) - x.low * inverse;
    return PackPair::sorted_sum(inverse, inverse * rest);
}

inline PackPair sqrt(const PackPair& x) {
    Pack half;
    const Pack root = root_and_half(x.high, half);
    return PackPair::sorted_sum(root, (PackPair::rest(root, root, x.high) + x.low) * half);
}

// Lane by lane.
template <class Function, class... Pairs> PackPair each_pair(const Function& f, const Pairs&... x) {
    PackPair result(0);
    for (std::size_t i = 0; i < pack_lanes; ++i) {
        const Twice<double> own = f(Twice<double>(x.high[i], x.low[i])...);
        result.high.set(i, own.high);
        result.low.set(i, own.low);
    }
    return result;
}
inline PackPair asinh(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return asinh(y); }, x);
}
inline PackPair exp(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return exp(y); }, x);
}
inline PackPair expm1(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return expm1(y); }, x);
}
inline PackPair log(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return log(y); }, x);
}
inline PackPair log1p(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return log1p(y); }, x);
}
inline PackPair sinh(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return sinh(y); }, x);
}
inline PackPair erf(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return math::erf(y); }, x);
}
inline PackPair sin(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return sin(y); }, x);
}
inline PackPair cos(const PackPair& x) {
    return each_pair([](const Twice<double>& y) { return cos(y); }, x);
}
inline PackPair hypot(const PackPair& x, const PackPair& y) {
    return each_pair([](const Twice<double>& a, const Twice<double>& b) { return hypot(a, b); }, x, y);
}
inline PackPair atan2(const PackPair& y, const PackPair& x) {
    return each_pair([](const Twice<double>& a, const Twice<double>& b) { return atan2(a, b); }, y, x);
}

} // namespace RESONFORM_WIDTH
} // namespace resonform::kernel

namespace resonform {

namespace math {
template <> inline constexpr int digits<kernel::PackPair> = 2 * 53;
template <> inline kernel::PackPair per<kernel::PackPair>(const kernel::PackPair& x) {
    return kernel::reciprocal(x);
}
template <> inline kernel::PackPair root<kernel::PackPair>(const kernel::PackPair& x, int k) {
    return kernel::each_pair([k](const Twice<double>& y) { return root(y, k); }, x);
}
} // namespace math

template <> struct OneOf<kernel::PackPair> { using type = Twice<double>; };
template <> inline constexpr bool notes_range<kernel::PackPair> = true;
template <> struct RangeNotesOf<kernel::PackPair> : RangeNotesOf<double> {};
template <> struct WideNumberOf<kernel::Pack> { using type = kernel::PackPair; };

inline kernel::PackPair spline(const Spline& of, int derivative, const kernel::PackPair& x) {
    return kernel::each_pair([&](const Twice<double>& y) { return of.at(derivative, y); }, x);
}

} // namespace resonform

#endif
