// SPDX-License-Identifier: MIT
// Several doubles at once, as wide as this file is compiled for. What depends on the width lives in an inline
// namespace of its name, so that units of several widths go into one program.
//
// Each multiply_add is one instruction where the processor has it and two roundings where it has not,
// whatever the compiler is told about contraction; no product stands where a compiler could fuse it with a
// sum.
#ifndef RESONFORM_RUNTIME_KERNEL_LANES
#define RESONFORM_RUNTIME_KERNEL_LANES

#include <cstddef>

#if defined(__FMA__)
#include <immintrin.h>
#endif

// The units of resonform::batch must not be taken for what a user compiles with further instructions.
#ifdef RESONFORM_BATCH_UNIT
#define RESONFORM_WIDTH_NAME(width) batch_##width
#else
#define RESONFORM_WIDTH_NAME(width) width
#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__FMA__)
#define RESONFORM_WIDTH RESONFORM_WIDTH_NAME(avx512)
#define RESONFORM_LANES 8
#elif defined(__AVX2__) && defined(__FMA__)
#define RESONFORM_WIDTH RESONFORM_WIDTH_NAME(avx2)
#define RESONFORM_LANES 4
#elif defined(__FMA__)
#define RESONFORM_WIDTH RESONFORM_WIDTH_NAME(baseline_fused)
#define RESONFORM_LANES 2
#else
#define RESONFORM_WIDTH RESONFORM_WIDTH_NAME(baseline)
#define RESONFORM_LANES 2
#endif

// Vectors of points side by side: enough to fill the pipelines, few enough for the registers.
#ifndef RESONFORM_VECTORS
#define RESONFORM_VECTORS 4
#endif

#ifdef __clang__
#define RESONFORM_UNROLL _Pragma("unroll")
#else
#define RESONFORM_UNROLL _Pragma("GCC unroll 16")
#endif

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

template <int N> struct VectorOf;
template <> struct VectorOf<2> {
    typedef double Vector __attribute__((vector_size(16)));
    typedef long long Bits __attribute__((vector_size(16)));
    typedef double Unaligned __attribute__((vector_size(16), aligned(8), may_alias));
#if defined(__FMA__)
    [[gnu::always_inline]] static Vector fused(Vector a, Vector b, Vector c) { return _mm_fmadd_pd(a, b, c); }
#endif
};
#if RESONFORM_LANES > 2
template <> struct VectorOf<4> {
    typedef double Vector __attribute__((vector_size(32)));
    typedef long long Bits __attribute__((vector_size(32)));
    typedef double Unaligned __attribute__((vector_size(32), aligned(8), may_alias));
    [[gnu::always_inline]] static Vector fused(Vector a, Vector b, Vector c) {
        return _mm256_fmadd_pd(a, b, c);
    }
};
#endif
#if RESONFORM_LANES > 4
template <> struct VectorOf<8> {
    typedef double Vector __attribute__((vector_size(64)));
    typedef long long Bits __attribute__((vector_size(64)));
    typedef double Unaligned __attribute__((vector_size(64), aligned(8), may_alias));
    [[gnu::always_inline]] static Vector fused(Vector a, Vector b, Vector c) {
        return _mm512_fmadd_pd(a, b, c);
    }
};
#endif

template <int N> struct Lanes {
    using Vector = typename VectorOf<N>::Vector;
    using Bits = typename VectorOf<N>::Bits;
    using Unaligned = typename VectorOf<N>::Unaligned;
    template <int Count> using Several = Vector[static_cast<unsigned>(Count)];

    [[gnu::always_inline]] static Vector load(const double* from) {
        return *reinterpret_cast<const Unaligned*>(from);
    }
    [[gnu::always_inline]] static void store(double* to, Vector x) { *reinterpret_cast<Unaligned*>(to) = x; }
    [[gnu::always_inline]] static Vector all(double x) { return x - Vector{}; }
    [[gnu::always_inline]] static Bits bits(Vector x) { return reinterpret_cast<Bits>(x); }
    [[gnu::always_inline]] static Vector number(Bits x) { return reinterpret_cast<Vector>(x); }

    [[gnu::always_inline]] static Vector multiply_add(Vector a, Vector b, Vector c) {
#if defined(__FMA__)
        return VectorOf<N>::fused(a, b, c);
#else
        return a * b + c;
#endif
    }
    // A rounded product that the compiler cannot fuse with the sum that follows.
    [[gnu::always_inline]] static Vector product(Vector a, Vector b) {
        Vector p = a * b;
#if defined(__FMA__)
        __asm__("" : "+v"(p));
#endif
        return p;
    }
    // a b - p exactly, for p = product(a, b) (Dekker).
    [[gnu::always_inline]] static Vector product_error(Vector a, Vector b, Vector p) {
#if defined(__FMA__)
        return VectorOf<N>::fused(a, b, -p);
#else
        const Vector a1 = upper(a), a2 = a - a1, b1 = upper(b), b2 = b - b1;
        return ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2;
#endif
    }
    // The upper 26 bits: the product of two such numbers, or with what the mask has left, is exact.
    [[gnu::always_inline]] static Vector upper(Vector x) { return number(bits(x) & (-1LL << 27)); }
};

inline constexpr int lanes = RESONFORM_LANES;

} // namespace RESONFORM_WIDTH
} // namespace resonform::kernel

#endif
