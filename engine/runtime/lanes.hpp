// SPDX-License-Identifier: MIT
// What is written once for a number and for several side by side (runtime/pack.hpp).
#ifndef RESONFORM_RUNTIME_LANES
#define RESONFORM_RUNTIME_LANES

#include "runtime/math.hpp"

#include <type_traits>

namespace resonform {

// What is true of a number, or of each of several side by side.
template <class Real> struct LanesOf {
    static constexpr bool several = !std::is_same_v<typename OneOf<Real>::type, Real>;
    using Truth = decltype(Real(0) < Real(0));

    static Truth all() { return Real(0) < Real(1); }
    static Truth negated(const Truth& a) {
        if constexpr (several)
            return ~a;
        else
            return !a;
    }
    static Truth both(const Truth& a, const Truth& b) {
        if constexpr (several)
            return a & b;
        else
            return a && b;
    }
    static bool any(const Truth& a) {
        if constexpr (several)
            return a.any();
        else
            return a;
    }
    static Real chosen(const Truth& which, const Real& a, const Real& b) {
        if constexpr (several)
            return select(which, a, b);
        else
            return which ? a : b;
    }
};

} // namespace resonform

#endif
