// SPDX-License-Identifier: MIT
// A number type that is as many doubles wide as the processor computes at once, or twice as many where its
// registers suffice, since what follows upon each other takes long: an emitted function that is called with
// it evaluates several sets of arguments. A lane's bits do not depend on the other lanes.
//
// Comparisons are made lane by lane; a Mask is true where all lanes are.
#ifndef RESONFORM_RUNTIME_PACK_LANES
#define RESONFORM_RUNTIME_PACK_LANES

#include "runtime/kernel/lanes.hpp"

#include <cstddef>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

inline constexpr int vectors = lanes == 8 ? 2 : 1, pack_lanes = vectors * lanes;

// Comparisons of vectors, and what chooses by them.
struct Chosen {
    using L = Lanes<lanes>;
    using Vector = typename L::Vector;
#if RESONFORM_LANES == 8
    using Bits = __mmask8; // a bit a lane
    static constexpr unsigned all = 0xff;
    static Bits less(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OS); }
    static Bits equal(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
    static Vector select(Bits mask, Vector a, Vector b) { return _mm512_mask_blend_pd(mask, b, a); }
    static Vector larger(Vector a, Vector b) { return _mm512_mask_max_pd(a, all, b, a); }
    static Vector smaller(Vector a, Vector b) { return _mm512_mask_min_pd(a, all, b, a); }
    static bool at(Bits mask, int i) { return (mask >> i & 1) != 0; }
#else
    using Bits = typename L::Bits; // 0 or -1
    static Vector select(Bits mask, Vector a, Vector b) {
        return L::number((L::bits(a) & mask) | (L::bits(b) & ~mask));
    }
    static bool at(Bits mask, int i) { return mask[i] != 0; }
#if RESONFORM_LANES == 4
    static Bits less(Vector a, Vector b) { return L::bits(_mm256_cmp_pd(a, b, _CMP_LT_OS)); }
    static Bits equal(Vector a, Vector b) { return L::bits(_mm256_cmp_pd(a, b, _CMP_EQ_OQ)); }
    static Vector larger(Vector a, Vector b) { return _mm256_max_pd(b, a); }
    static Vector smaller(Vector a, Vector b) { return _mm256_min_pd(b, a); }
#elif defined(__SSE2__)
    static Bits less(Vector a, Vector b) { return L::bits(_mm_cmplt_pd(a, b)); }
    static Bits equal(Vector a, Vector b) { return L::bits(_mm_cmpeq_pd(a, b)); }
    static Vector larger(Vector a, Vector b) { return _mm_max_pd(b, a); }
    static Vector smaller(Vector a, Vector b) { return _mm_min_pd(b, a); }
#else
    static Bits less(Vector a, Vector b) { return reinterpret_cast<Bits>(a < b); }
    static Bits equal(Vector a, Vector b) { return reinterpret_cast<Bits>(a == b); }
    static Vector larger(Vector a, Vector b) { return select(less(a, b), b, a); }
    static Vector smaller(Vector a, Vector b) { return select(less(b, a), b, a); }
#endif
#endif
};

struct Mask {
    Chosen::Bits bits[vectors];

    template <class Function, class... Masks> static Mask of(const Function& f, const Masks&... x) {
        Mask result;
        RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) result.bits[k] =
            static_cast<Chosen::Bits>(f(x.bits[k]...));
        return result;
    }
    explicit operator bool() const { return !(~*this).any(); }
    [[nodiscard]] bool any() const {
#if RESONFORM_LANES == 8
        unsigned some = 0;
        for (int k = 0; k < vectors; ++k) some |= bits[k];
#else
        long long some = 0;
        for (int i = 0; i < pack_lanes; ++i) some |= bits[i / lanes][i % lanes];
#endif
        return some != 0;
    }
    bool operator[](std::size_t i) const { return Chosen::at(bits[i / lanes], static_cast<int>(i % lanes)); }
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
    typename L::Vector v[vectors];

    // No number: arrays of packs would be set to 0 first, which takes a tenth of a member's time.
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
    template <class Function>
    [[gnu::always_inline]] static Mask where(const Function& f, const Pack& a, const Pack& b) {
        Mask result;
        RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) result.bits[k] = f(a.v[k], b.v[k]);
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
    friend Mask operator<(const Pack& a, const Pack& b) { return where(Chosen::less, a, b); }
    friend Mask operator>(const Pack& a, const Pack& b) { return b < a; }
    friend Mask operator==(const Pack& a, const Pack& b) { return where(Chosen::equal, a, b); }
};

// Where the mask is true a, else b.
inline Pack select(const Mask& mask, const Pack& a, const Pack& b) {
    Pack result;
    RESONFORM_UNROLL for (int k = 0; k < vectors; ++k) result.v[k] =
        Chosen::select(mask.bits[k], a.v[k], b.v[k]);
    return result;
}
inline Pack magnitude(const Pack& a) {
    using L = Pack::L;
    return Pack::of([](auto x) { return L::number(L::bits(x) & ~(1LL << 63)); }, a);
}
// a, unless b is larger, or smaller; as with doubles, a number b that is none is passed over.
inline Pack larger(const Pack& a, const Pack& b) { return Pack::of(Chosen::larger, a, b); }
inline Pack smaller(const Pack& a, const Pack& b) { return Pack::of(Chosen::smaller, a, b); }

// Lane by lane.
template <class Function, class... Packs> Pack each(const Function& f, const Packs&... x) {
    Pack result(0);
    for (std::size_t i = 0; i < pack_lanes; ++i) result.set(i, f(x[i]...));
    return result;
}

} // namespace RESONFORM_WIDTH
} // namespace resonform::kernel

#endif
