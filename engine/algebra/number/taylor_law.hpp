// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor coefficients at 0 that need no recurrence: of log(1 + u) for log.
#pragma once

#include "algebra/number/functions.hpp"

namespace resonform {

// The c_k that are not zero, those of odd, of even or of all k: 1/k!, 1/k or binomial(2j, j)/4^j/k with j =
// (k - 1)/2. If `alternating`, every second one is negative.
struct TaylorLaw {
    enum { factorial, reciprocal, central } kind = factorial;
    bool odd = true, even = false, alternating = false;

    [[nodiscard]] bool has(int k) const { return k % 2 != 0 ? odd : even && (k > 0 || kind == factorial); }
    [[nodiscard]] bool negative(int k) const {
        return alternating && (odd && even ? k % 2 == 0 : k % 4 >= 2);
    }
};

// Whether f is expanded by its Taylor sum. The others are integrals of their slopes.
constexpr bool has_taylor_law(Function f) {
    switch (f) {
    case Function::inverse_hyperbolic_sine:
    case Function::inverse_hyperbolic_cosine:
    case Function::inverse_hyperbolic_tangent:
    case Function::error_function: return false;
    default: return true;
    }
}

// Precondition: f has a law, and is neither tan nor tanh, which are quotients.
constexpr TaylorLaw taylor_law(Function f) {
    switch (f) {
    case Function::exponential: return {TaylorLaw::factorial, true, true, false};
    case Function::sine: return {TaylorLaw::factorial, true, false, true};
    case Function::cosine: return {TaylorLaw::factorial, false, true, true};
    case Function::hyperbolic_cosine: return {TaylorLaw::factorial, false, true, false};
    case Function::arc_tangent: return {TaylorLaw::reciprocal, true, false, true};
    case Function::arc_sine: return {TaylorLaw::central, true, false, false};
    case Function::logarithm: return {TaylorLaw::reciprocal, true, true, true};
    default: return {TaylorLaw::factorial, true, false, false}; // sinh
    }
}

} // namespace resonform
