// SPDX-License-Identifier: GPL-3.0-or-later
// The unit in which emitted code is judged.
#pragma once

#include "verify/symbolic/terms.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace resonform {

// The share of the points drawn that must have numbers: with fewer there is no verdict.
inline constexpr double compared_share = 0.1;

// |value - exact| over the spacing of Real at the scale of an output (docs/theory.md); infinite if there is
// no value.
template <class Real, class Value> double in_ulp(const Value& value, const Wide& exact, const Wide& scale) {
    // The least of them is no denormal number on its way into Wide: with clang that became 0.
    const Wide one = std::numeric_limits<Real>::epsilon(), spacing = scale * one,
               least = Wide(std::numeric_limits<Real>::min()) * one;
    const Wide error = abs(Wide(Wide(value) - exact)) / (spacing < least ? least : spacing);
    return isfinite(error) ? static_cast<double>(error) : std::numeric_limits<double>::infinity();
}

// t by 4 ulp of Real later, and earlier: a status may be another one that close to where it changes.
template <class Real> std::array<Wide, 2> times_at_edge(const Real& t) {
    const Wide step = 4 * Wide(std::numeric_limits<Real>::epsilon()) * Wide(t);
    return {Wide(t) + step, Wide(t) - step};
}

// The relative precision of a phase in emitted code: that of two Reals, or of one where its rate is
// tabulated.
template <class Real> Wide phase_resolution(bool is_flow) {
    const Wide one = std::numeric_limits<Real>::epsilon();
    return is_flow ? one : Wide(4 * one * one);
}

} // namespace resonform
