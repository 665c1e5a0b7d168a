// SPDX-License-Identifier: MIT
// The elementary functions of __float128 (libquadmath), declared here because clang does not find
// g++'s <quadmath.h>. A program that uses them links with -lquadmath; others need not.
#ifndef RESONFORM_RUNTIME_FLOAT128
#define RESONFORM_RUNTIME_FLOAT128

#include <cstddef> // defines __GLIBCXX__

#if defined(__SIZEOF_FLOAT128__) && defined(__GLIBCXX__)
#define RESONFORM_FLOAT128 1

namespace resonform {
__extension__ using Float128 = __float128;
}

extern "C" {
resonform::Float128 sqrtq(resonform::Float128) noexcept;
resonform::Float128 powq(resonform::Float128, resonform::Float128) noexcept;
resonform::Float128 sinq(resonform::Float128) noexcept;
resonform::Float128 cosq(resonform::Float128) noexcept;
resonform::Float128 expq(resonform::Float128) noexcept;
resonform::Float128 logq(resonform::Float128) noexcept;
resonform::Float128 expm1q(resonform::Float128) noexcept;
resonform::Float128 log1pq(resonform::Float128) noexcept;
resonform::Float128 sinhq(resonform::Float128) noexcept;
resonform::Float128 erfq(resonform::Float128) noexcept;
resonform::Float128 asinhq(resonform::Float128) noexcept;
resonform::Float128 atan2q(resonform::Float128, resonform::Float128) noexcept;
resonform::Float128 hypotq(resonform::Float128, resonform::Float128) noexcept;
resonform::Float128 floorq(resonform::Float128) noexcept;
}

namespace resonform::math {

inline Float128 sqrt(Float128 x) noexcept { return sqrtq(x); }
inline Float128 pow(Float128 x, Float128 y) noexcept { return powq(x, y); }
inline Float128 sin(Float128 x) noexcept { return sinq(x); }
inline Float128 cos(Float128 x) noexcept { return cosq(x); }
inline Float128 exp(Float128 x) noexcept { return expq(x); }
inline Float128 log(Float128 x) noexcept { return logq(x); }
inline Float128 expm1(Float128 x) noexcept { return expm1q(x); }
inline Float128 log1p(Float128 x) noexcept { return log1pq(x); }
inline Float128 sinh(Float128 x) noexcept { return sinhq(x); }
inline Float128 erf(Float128 x) noexcept { return erfq(x); }
inline Float128 asinh(Float128 x) noexcept { return asinhq(x); }
inline Float128 atan2(Float128 y, Float128 x) noexcept { return atan2q(y, x); }
inline Float128 hypot(Float128 x, Float128 y) noexcept { return hypotq(x, y); }
inline Float128 floor(Float128 x) noexcept { return floorq(x); }

} // namespace resonform::math
#endif

#endif
