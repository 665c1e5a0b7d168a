// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that end where pieces of data end: behind a breakpoint the solution has another Taylor series.
#pragma once

#include "verify/integrate/tape.hpp"
#include "verify/run/spline.hpp"

#include <cstddef>
#include <limits>
#include <optional>

namespace resonform {

// How far a step goes beyond a breakpoint, in units of the next piece, so that the next step begins in the
// next piece for certain. Of what the two pieces differ in there a power remains that is no number.
inline constexpr double beyond_breakpoint = 1e-9;

// The value that a state has when a step ends, going up or down from x; nullopt: there is no breakpoint
// ahead.
template <class Real>
std::optional<double> end_of_piece(const PiecewisePolynomial& data, const Real& x, bool up) {
    const std::vector<double>& at = data.breakpoints;
    if (x < Real(at.front()) || Real(at.back()) < x) return std::nullopt;
    const std::size_t piece = spline_of(data).piece(x);
    const std::size_t ahead = up ? piece + 1 : piece;
    const double width = at[piece + 1] - at[piece];
    return up ? at[ahead] + beyond_breakpoint * width : at[ahead] - beyond_breakpoint * width;
}

// The length of a step of at most h after which a state with the Taylor coefficients c, 0 ... order, has not
// gone further than just beyond the next breakpoint.
template <class Real>
double within_piece(const PiecewisePolynomial& data, const Real* c, int order, double h) {
    const bool up = Real(0) < c[1];
    if (!up && !(c[1] < Real(0))) return h;
    const std::optional<double> end = end_of_piece(data, c[0], up);
    if (!end) return h;
    const double way = to_double_value(Real(Real(*end) - c[0]));
    const auto gone = [&](double step) { // whether it is passed
        double sum = 0;
        for (int k = order; k > 0; --k) sum = (sum + to_double_value(c[k])) * step;
        return up ? sum > way : sum < way;
    };
    double before = 0,
           after = h < std::numeric_limits<double>::max() ? h : std::numeric_limits<double>::max();
    const double straight = way / to_double_value(c[1]);
    if (gone(2 * straight) && 2 * straight < after) after = 2 * straight;
    if (!gone(after)) return h;
    for (int k = 0; k < std::numeric_limits<double>::digits; ++k) {
        const double middle = before + (after - before) / 2;
        (gone(middle) ? after : before) = middle;
    }
    return after;
}

} // namespace resonform
