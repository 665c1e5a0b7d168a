// SPDX-License-Identifier: MIT
// Functions of several doubles side by side, as emitted code calls them. They want arguments of moderate
// size: beyond it (cosines of more than 2^23, squares of hypot and asinh out of range) a lane is not a
// number.
#ifndef RESONFORM_RUNTIME_PACK
#define RESONFORM_RUNTIME_PACK

#include "runtime/in_range.hpp"
#include "runtime/kernel/block.hpp"
#include "runtime/pack_lanes.hpp"
#include "runtime/spline.hpp"

#include <cmath>
#include <cstddef>

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

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
// The same of sqrt(x), x >= 0 finite, and half of the digits of 1/(2 sqrt(x)); 0 and 0 for 0.
inline Pack root_and_half(const Pack& x, Pack& half) {
    using L = Pack::L;
    using Vector = typename L::Vector;
    Pack result;
    RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) {
        const Vector y = _mm512_maskz_rsqrt14_pd(_mm512_cmpneq_pd_mask(x.v[k], Vector{}), x.v[k]);
        const Vector rough = x.v[k] * y, h = L::all(0.5) * y;
        const Vector rest = L::multiply_add(-rough, h, L::all(0.5));
        const Vector root = L::multiply_add(rough, rest, rough);
        half.v[k] = L::multiply_add(h, rest, h);
        result.v[k] = L::multiply_add(L::multiply_add(-root, root, x.v[k]), half.v[k], root);
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

inline Pack erf(const Pack& x) {
    return each([](double y) { return std::erf(y); }, x);
}
inline Pack exp(const Pack& x) {
    return each([](double y) { return std::exp(y); }, x);
}
inline Pack expm1(const Pack& x) {
    return each([](double y) { return std::expm1(y); }, x);
}
// log(y) + c/y as fdlibm's log1p makes it, y > 0 neither subnormal nor infinite, |c| below the last place of
// y.
inline Pack log_and_rest(const Pack& y, const Pack& c) {
    using L = Pack::L;
    using Whole = unsigned long long __attribute__((vector_size(sizeof(L::Bits))));
    constexpr unsigned long long one = 0x3ff0000000000000, half_root = 0x3fe6a09e00000000;
    Pack f, k; // y = 2^k (1 + f), 1 + f between sqrt(1/2) and sqrt(2)
    RESONFORM_UNROLL for (int i = 0; i < vectors; ++i) {
        const Whole bits = reinterpret_cast<Whole>(y.v[i]) + (one - half_root);
        k.v[i] = reinterpret_cast<L::Vector>((bits >> 52) | 0x4330000000000000) - L::all(0x1p52 + 1023);
        f.v[i] = reinterpret_cast<L::Vector>((bits & ((1ULL << 52) - 1)) + half_root) - L::all(1);
    }
    const Pack half_square = Pack(0.5) * f * f, s = f * reciprocal(Pack(2) + f), z = s * s, w = z * z;
    const Pack even = w * (Pack(3.999999999940942e-01) +
                           w * (Pack(2.222219843214978e-01) + w * Pack(1.531383769920937e-01)));
    const Pack odd = z * (Pack(6.666666666666735e-01) +
                          w * (Pack(2.857142874366239e-01) +
                               w * (Pack(1.818357216161805e-01) + w * Pack(1.479819860511659e-01))));
    const Pack high(6.93147180369123816490e-01), low(1.90821492927058770002e-10); // of log 2
    return s * (half_square + (odd + even)) + (k * low + c * reciprocal(y)) - half_square + f + k * high;
}
inline Pack log(const Pack& x) {
    const Mask known = (x > Pack(0x1p-1000)) & (x < Pack(0x1p1000));
    return select(known, log_and_rest(x, Pack(0)), Pack(NAN));
}
inline Pack log1p(const Pack& x) {
    const Pack y = Pack(1) + x, c = select(y < Pack(2), x - (y - Pack(1)), Pack(1) - (y - x));
    const Mask known = (y > Pack(0x1p-1000)) & (y < Pack(0x1p1000));
    return select(known, log_and_rest(y, c), Pack(NAN));
}
inline Pack asinh(const Pack& x) {
    const Pack size = magnitude(x), square = x * x;
    const Pack result = log1p(size + square * reciprocal(Pack(1) + sqrt(Pack(1) + square)));
    return select(x < Pack(0), -result, result);
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
    if constexpr (kernel::lanes == 8) return kernel::reciprocal(x);
    return kernel::reciprocal(x) + (x - x);
}
template <> inline kernel::Pack larger<kernel::Pack>(const kernel::Pack& a, const kernel::Pack& b) {
    return kernel::larger(a, b);
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
