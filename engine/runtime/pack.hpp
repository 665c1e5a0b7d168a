// SPDX-License-Identifier: MIT
// A number type that is as many doubles wide as the processor computes at once: an emitted function that is
// called with it evaluates several sets of arguments. A lane's bits do not depend on the other lanes.
//
// Comparisons are made lane by lane; a Mask is true where all lanes are. Functions want arguments of moderate
// size: beyond it (cosines of more than 2^23, squares of hypot out of range) a lane is not a number.
#ifndef RESONFORM_RUNTIME_PACK
#define RESONFORM_RUNTIME_PACK

#include "runtime/in_range.hpp"
#include "runtime/kernel/block.hpp"
#include "runtime/spline.hpp"
#include "runtime/twice.hpp"

#include <cmath>
#include <cstddef>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

struct Mask {
    typename Lanes<lanes>::Bits bits; // 0 or -1

    explicit operator bool() const {
        long long all = -1;
        for (int i = 0; i < lanes; ++i) all &= bits[i];
        return all != 0;
    }
    [[nodiscard]] bool any() const {
        long long some = 0;
        for (int i = 0; i < lanes; ++i) some |= bits[i];
        return some != 0;
    }
    bool operator[](std::size_t i) const { return bits[i] != 0; }
    friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
    friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
    friend Mask operator~(Mask a) { return {~a.bits}; }
};

struct Pack {
    using L = Lanes<lanes>;
    typename L::Vector v{};

    Pack() = default;
    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit Pack(Number x) : v(L::all(static_cast<double>(x))) {}
    static Pack of(typename L::Vector x) {
        Pack result;
        result.v = x;
        return result;
    }
    static Pack load(const double* x) { return of(L::load(x)); }
    void store(double* x) const { L::store(x, v); }
    double operator[](std::size_t i) const { return v[i]; }

    [[gnu::always_inline]] friend Pack operator-(const Pack& a) { return of(-a.v); }
    [[gnu::always_inline]] friend Pack operator+(const Pack& a, const Pack& b) { return of(a.v + b.v); }
    [[gnu::always_inline]] friend Pack operator-(const Pack& a, const Pack& b) { return of(a.v - b.v); }
    [[gnu::always_inline]] friend Pack operator*(const Pack& a, const Pack& b) { return of(a.v * b.v); }
    [[gnu::always_inline]] friend Pack operator/(const Pack& a, const Pack& b) { return of(a.v / b.v); }
    friend Mask operator<(const Pack& a, const Pack& b) { return {a.v < b.v}; }
    friend Mask operator>(const Pack& a, const Pack& b) { return {a.v > b.v}; }
    friend Mask operator==(const Pack& a, const Pack& b) { return {a.v == b.v}; }
};

// Where the mask is true a, else b.
inline Pack select(Mask mask, const Pack& a, const Pack& b) {
    using L = Pack::L;
    return Pack::of(L::number((L::bits(a.v) & mask.bits) | (L::bits(b.v) & ~mask.bits)));
}
inline Pack magnitude(const Pack& x) { return Pack::of(Pack::L::number(Pack::L::bits(x.v) & ~(1LL << 63))); }

// Lane by lane.
template <class Function, class... Packs> Pack each(const Function& f, const Packs&... x) {
    Pack result;
    for (int i = 0; i < lanes; ++i) result.v[i] = f(x.v[i]...);
    return result;
}

inline Pack sqrt(const Pack& x) {
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__FMA__)
    return Pack::of(_mm512_maskz_sqrt_pd(0xff, x.v)); // the plain one confuses g++ 12
#elif defined(__AVX2__) && defined(__FMA__)
    return Pack::of(_mm256_sqrt_pd(x.v));
#elif defined(__SSE2__)
    return Pack::of(_mm_sqrt_pd(x.v));
#else
    return each([](double y) { return std::sqrt(y); }, x);
#endif
}

// The next whole number, |x| < 2^51, and its bits in the last places.
inline Pack::L::Vector turned(const Pack& x) { return x.v + 0x1.8p52; }
inline Pack whole(const Pack& x) { return Pack::of(turned(x) - 0x1.8p52); }

// Of an angle in quarter turns, |f| <= 1/2 and a little, beside whole ones.
inline void cosine_and_sine(const Pack& f, const Pack::L::Vector& turns, Pack& cosine, Pack& sine) {
    cosine_and_sine<lanes>(f.v, turns, cosine.v, sine.v);
}

// With the digits of x where it is near a multiple of a quarter turn, too (Cody and Waite).
inline void cosine_and_sine(const Pack& x, Pack& cosine, Pack& sine) {
    // pi/2 as numbers of 29 bits and the rest: products with whole numbers below 2^24 are exact
    const Pack first(0x1.921fb54p+0), second(0x1.10b4611p-30), third(0x1.4c4c6628b80dcp-59);
    const Pack quarters = whole(x * Pack(0.63661977236758134));
    const Pack rest = ((x - quarters * first) - quarters * second) - quarters * third;
    cosine_and_sine(rest * Pack(0.63661977236758134), turned(quarters), cosine, sine);
    const Mask known = magnitude(x) < Pack(0x1p23);
    cosine = select(known, cosine, Pack(NAN));
    sine = select(known, sine, Pack(NAN));
}
inline Pack cos(const Pack& x) {
    Pack cosine, sine;
    cosine_and_sine(x, cosine, sine);
    return cosine;
}
inline Pack sin(const Pack& x) {
    Pack cosine, sine;
    cosine_and_sine(x, cosine, sine);
    return sine;
}

inline Pack hypot(const Pack& x, const Pack& y) {
    const Pack square = x * x + y * y;
    const Mask fits = (square > Pack(0x1p-900)) & (square < Pack(0x1p1000));
    return select(fits | ((x == Pack(0)) & (y == Pack(0))), sqrt(square), Pack(NAN));
}

inline Pack asinh(const Pack& x) {
    return each([](double y) { return std::asinh(y); }, x);
}
inline Pack erf(const Pack& x) {
    return each([](double y) { return std::erf(y); }, x);
}
inline Pack exp(const Pack& x) {
    return each([](double y) { return std::exp(y); }, x);
}
inline Pack expm1(const Pack& x) {
    return each([](double y) { return std::expm1(y); }, x);
}
inline Pack log(const Pack& x) {
    return each([](double y) { return std::log(y); }, x);
}
inline Pack log1p(const Pack& x) {
    return each([](double y) { return std::log1p(y); }, x);
}
inline Pack sinh(const Pack& x) {
    return each([](double y) { return std::sinh(y); }, x);
}
inline Pack atan2(const Pack& y, const Pack& x) {
    return each([](double a, double b) { return std::atan2(a, b); }, y, x);
}

// high + low: twice the digits but a few, |low| about a unit of the last place of high.
struct PackPair {
    Pack high, low;

    PackPair() = default;
    PackPair(const Pack& h, const Pack& l) : high(h), low(l) {}
    explicit PackPair(const Pack& x) : high(x) {}
    explicit PackPair(const Twice<double>& x) : high(x.high), low(x.low) {}
    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit PackPair(Number x) : high(x) {}
    explicit operator Pack() const { return high + low; }

    static PackPair product(const Pack& a, const Pack& b) {
        const typename Pack::L::Vector p = Pack::L::product(a.v, b.v);
        return {Pack::of(p), Pack::of(Pack::L::product_error(a.v, b.v, p))};
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
        return sorted_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
    }
    friend PackPair operator/(const PackPair& a, const PackPair& b) {
        const Pack q = a.high / b.high;
        const PackPair p = product(q, b.high);
        return sorted_sum(q, (((a.high - p.high) - p.low) + (a.low - q * b.low)) / b.high);
    }
    friend Mask operator<(const PackPair& a, const PackPair& b) { return (a - b).high < Pack(0); }
    friend Mask operator>(const PackPair& a, const PackPair& b) { return b < a; }
    friend Mask operator==(const PackPair& a, const PackPair& b) {
        return (a.high == b.high) & (a.low == b.low);
    }
};

inline PackPair sqrt(const PackPair& x) {
    const Pack root = sqrt(x.high), none(0);
    const PackPair square = PackPair::product(root, root);
    const Pack rest = ((x.high - square.high) - square.low) + x.low;
    return PackPair::sorted_sum(root, select(x.high > none, rest / (root + root), none));
}

// Lane by lane.
template <class Function, class... Pairs> PackPair each_pair(const Function& f, const Pairs&... x) {
    PackPair result;
    for (int i = 0; i < lanes; ++i) {
        const Twice<double> own = f(Twice<double>(x.high.v[i], x.low.v[i])...);
        result.high.v[i] = own.high;
        result.low.v[i] = own.low;
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
template <> inline constexpr int digits<kernel::Pack> = 53;
template <> inline kernel::Pack epsilon<kernel::Pack>() { return kernel::Pack(0x1p-52); }
template <> inline kernel::Pack magnitude<kernel::Pack>(const kernel::Pack& x) {
    return kernel::magnitude(x);
}
template <> inline bool finite<kernel::Pack>(const kernel::Pack& x) { return bool(x - x == kernel::Pack(0)); }
template <> inline kernel::Pack larger<kernel::Pack>(const kernel::Pack& a, const kernel::Pack& b) {
    return select(a < b, b, a);
}
template <> inline kernel::Pack smaller<kernel::Pack>(const kernel::Pack& a, const kernel::Pack& b) {
    return select((b < a) | ~(b == b), b, a);
}
template <> inline kernel::Pack root<kernel::Pack>(const kernel::Pack& x, int k) {
    return kernel::each([k](double y) { return root(y, k); }, x);
}
template <> inline constexpr int digits<kernel::PackPair> = 2 * 53;
template <> inline kernel::PackPair root<kernel::PackPair>(const kernel::PackPair& x, int k) {
    return kernel::each_pair([k](const Twice<double>& y) { return root(y, k); }, x);
}
} // namespace math

template <> struct OneOf<kernel::Pack> { using type = double; };
template <> struct OneOf<kernel::PackPair> { using type = Twice<double>; };
template <> inline constexpr bool notes_range<kernel::Pack> = true;
template <> inline constexpr bool notes_range<kernel::PackPair> = true;
template <> struct RangeNotesOf<kernel::Pack> : RangeNotesOf<double> {};
template <> struct RangeNotesOf<kernel::PackPair> : RangeNotesOf<double> {};
template <> struct WideNumberOf<kernel::Pack> { using type = kernel::PackPair; };

inline kernel::Pack spline(const Spline& of, int derivative, const kernel::Pack& x) {
    return kernel::each([&](double y) { return of.at(derivative, y); }, x);
}
inline kernel::PackPair spline(const Spline& of, int derivative, const kernel::PackPair& x) {
    return kernel::each_pair([&](const Twice<double>& y) { return of.at(derivative, y); }, x);
}

} // namespace resonform

#endif
