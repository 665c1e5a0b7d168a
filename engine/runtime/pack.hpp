// SPDX-License-Identifier: MIT
// A number type that is as many doubles wide as the processor computes at once, or twice as many where its
// registers suffice, since what follows upon each other takes long: an emitted function that is called with
// it evaluates several sets of arguments. A lane's bits do not depend on the other lanes.
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

inline constexpr int vectors = lanes == 8 ? 2 : 1, pack_lanes = vectors * lanes;

struct Mask {
    typename Lanes<lanes>::Bits bits[vectors]; // 0 or -1

    template <class Function, class... Masks> static Mask of(const Function& f, const Masks&... x) {
        Mask result;
        RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) result.bits[k] = f(x.bits[k]...);
        return result;
    }
    explicit operator bool() const {
        long long all = -1;
        for (int i = 0; i < pack_lanes; ++i) all &= bits[i / lanes][i % lanes];
        return all != 0;
    }
    [[nodiscard]] bool any() const {
        long long some = 0;
        for (int i = 0; i < pack_lanes; ++i) some |= bits[i / lanes][i % lanes];
        return some != 0;
    }
    bool operator[](std::size_t i) const { return bits[i / lanes][i % lanes] != 0; }
    friend Mask operator&(const Mask& a, const Mask& b) {
        return of([](auto x, auto y) { return x & y; }, a, b);
    }
    friend Mask operator|(const Mask& a, const Mask& b) {
        return of([](auto x, auto y) { return x | y; }, a, b);
    }
    friend Mask operator~(const Mask& a) {
        return of([](auto x) { return ~x; }, a);
    }
};

struct Pack {
    using L = Lanes<lanes>;
    typename L::Vector v[vectors]{};

    Pack() = default;
    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit Pack(Number x) {
        RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) v[k] = L::all(static_cast<double>(x));
    }
    // Vector by vector.
    template <class Function, class... Packs>
    [[gnu::always_inline]] static Pack of(const Function& f, const Packs&... x) {
        Pack result;
        RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) result.v[k] = f(x.v[k]...);
        return result;
    }
    template <class Function, class... Packs>
    [[gnu::always_inline]] static Mask where(const Function& f, const Packs&... x) {
        Mask result;
        RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) result.bits[k] =
            reinterpret_cast<typename L::Bits>(f(x.v[k]...));
        return result;
    }
    static Pack load(const double* x) {
        Pack result;
        RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) result.v[k] = L::load(x + k * lanes);
        return result;
    }
    void store(double* x) const {
        RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) L::store(x + k * lanes, v[k]);
    }
    double operator[](std::size_t i) const { return v[i / lanes][i % lanes]; }
    void set(std::size_t i, double x) { v[i / lanes][i % lanes] = x; }

    [[gnu::always_inline]] friend Pack operator-(const Pack& a) {
        return of([](auto x) { return -x; }, a);
    }
    [[gnu::always_inline]] friend Pack operator+(const Pack& a, const Pack& b) {
        return of([](auto x, auto y) { return x + y; }, a, b);
    }
    [[gnu::always_inline]] friend Pack operator-(const Pack& a, const Pack& b) {
        return of([](auto x, auto y) { return x - y; }, a, b);
    }
    [[gnu::always_inline]] friend Pack operator*(const Pack& a, const Pack& b) {
        return of([](auto x, auto y) { return x * y; }, a, b);
    }
    [[gnu::always_inline]] friend Pack operator/(const Pack& a, const Pack& b) {
        return of([](auto x, auto y) { return x / y; }, a, b);
    }
    friend Mask operator<(const Pack& a, const Pack& b) {
        return where([](auto x, auto y) { return x < y; }, a, b);
    }
    friend Mask operator>(const Pack& a, const Pack& b) { return b < a; }
    friend Mask operator==(const Pack& a, const Pack& b) {
        return where([](auto x, auto y) { return x == y; }, a, b);
    }
};

// Where the mask is true a, else b.
inline Pack select(const Mask& mask, const Pack& a, const Pack& b) {
    using L = Pack::L;
    Pack result;
    RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) result.v[k] =
        L::number((L::bits(a.v[k]) & mask.bits[k]) | (L::bits(b.v[k]) & ~mask.bits[k]));
    return result;
}
inline Pack magnitude(const Pack& a) {
    using L = Pack::L;
    return Pack::of([](auto x) { return L::number(L::bits(x) & ~(1LL << 63)); }, a);
}

// Lane by lane.
template <class Function, class... Packs> Pack each(const Function& f, const Packs&... x) {
    Pack result;
    for (std::size_t i = 0; i < pack_lanes; ++i) result.set(i, f(x[i]...));
    return result;
}

#if RESONFORM_LANES == 8
// 1/x but for a last bit, in a third of the time of a division: Newton steps from 14 bits. Not a number where
// x is 0 or not finite.
inline Pack reciprocal(const Pack& x) {
    using L = Pack::L;
    return Pack::of(
        [](auto one) {
            typename L::Vector y = _mm512_maskz_rcp14_pd(0xff, one);
            for (int step = 0; step < 2; ++step)
                y = L::multiply_add(L::multiply_add(-one, y, L::all(1)), y, y);
            return y;
        },
        x);
}
// The same of sqrt(x) and 1/(2 sqrt(x)), x >= 0 finite; 0 and 0 for 0.
inline Pack root_and_half(const Pack& x, Pack& half) {
    using L = Pack::L;
    using Vector = typename L::Vector;
    Pack result;
    RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) {
        const Vector y = _mm512_maskz_rsqrt14_pd(_mm512_cmpneq_pd_mask(x.v[k], Vector{}), x.v[k]);
        Vector root = x.v[k] * y, h = L::all(0.5) * y;
        for (int step = 0; step < 2; ++step) {
            const Vector rest = L::multiply_add(-root, h, L::all(0.5));
            root = L::multiply_add(root, rest, root);
            h = L::multiply_add(h, rest, h);
        }
        half.v[k] = h;
        result.v[k] = L::multiply_add(L::multiply_add(-root, root, x.v[k]), h, root);
    }
    return result;
}
inline Pack sqrt(const Pack& x) {
    Pack half;
    return root_and_half(x, half);
}
#else
inline Pack reciprocal(const Pack& x) { return Pack(1) / x; }
inline Pack sqrt(const Pack& x) {
#if defined(__AVX2__) && defined(__FMA__)
    return Pack::of([](auto y) { return _mm256_sqrt_pd(y); }, x);
#elif defined(__SSE2__)
    return Pack::of([](auto y) { return _mm_sqrt_pd(y); }, x);
#else
    return each([](double y) { return std::sqrt(y); }, x);
#endif
}
inline Pack root_and_half(const Pack& x, Pack& half) {
    const Pack root = sqrt(x), none(0);
    half = select(x > none, Pack(0.5) / root, none);
    return root;
}
#endif

// The next whole number, |x| < 2^51, and its bits in the last places.
inline Pack turned(const Pack& x) { return x + Pack(0x1.8p52); }
inline Pack whole(const Pack& x) { return turned(x) - Pack(0x1.8p52); }

// Of an angle in quarter turns, |f| <= 1/2 and a little, beside whole ones.
inline void cosine_and_sine(const Pack& f, const Pack& turns, Pack& cosine, Pack& sine) {
    RESONFORM_UNROLL for (int k = 0; k < vectors; ++k)
        cosine_and_sine<lanes>(f.v[k], turns.v[k], cosine.v[k], sine.v[k]);
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
// NOLINTNEXTLINE(misc-redundant-expression): as the template
template <> inline kernel::Pack per<kernel::Pack>(const kernel::Pack& x) {
    return kernel::reciprocal(x) + (x - x);
}
template <> inline kernel::Pack larger<kernel::Pack>(const kernel::Pack& a, const kernel::Pack& b) {
    return select(a < b, b, a);
}
template <> inline kernel::Pack smaller<kernel::Pack>(const kernel::Pack& a, const kernel::Pack& b) {
    return select((b < a) | ~(b == b), b, a);
}
template <> inline kernel::Pack root<kernel::Pack>(const kernel::Pack& x, int k) {
    return kernel::each([k](double y) { return root(y, k); }, x);
}
} // namespace math

template <> struct OneOf<kernel::Pack> { using type = double; };
template <> inline constexpr bool notes_range<kernel::Pack> = true;
template <> struct RangeNotesOf<kernel::Pack> : RangeNotesOf<double> {};

inline kernel::Pack spline(const Spline& of, int derivative, const kernel::Pack& x) {
    return kernel::each([&](double y) { return of.at(derivative, y); }, x);
}

} // namespace resonform

#endif
