// SPDX-License-Identifier: MIT
// A function that is known by samples: a polynomial in each of several intervals side by side. Its numbers
// are doubles, which every real type holds:
//
//   S(x) = sum_j c[k][j] (x - x_k)^j    on  x_k <= x < x_{k+1}
//
// What is integrated has to end its panels where pieces end (runtime/pieces.hpp).
#ifndef RESONFORM_RUNTIME_SPLINE
#define RESONFORM_RUNTIME_SPLINE

#include "runtime/math.hpp"
#include "runtime/scaled.hpp"

#include <cstddef>

namespace resonform {

struct Spline {
    const double* breakpoints;  // pieces + 1
    const double* coefficients; // degree + 1 of each piece
    std::size_t pieces;
    int degree;

    // The derivative-th derivative at x; not a number outside of the range, but for rounding.
    template <class Real> [[nodiscard]] Real at(int derivative, const Real& x) const {
        if (!holds(x)) return math::not_a_number<Real>();
        const std::size_t k = piece(x);
        const double* c = coefficients + k * (static_cast<std::size_t>(degree) + 1);
        const Real u = x - Real(breakpoints[k]);
        Real sum = Real(0);
        for (int j = degree; j >= derivative; --j) {
            double factor = 1;
            for (int i = 0; i < derivative; ++i) factor *= j - i;
            sum = sum * u + Real(c[j]) * Real(factor);
        }
        return sum;
    }

    template <class Real> [[nodiscard]] bool holds(const Real& x) const {
        const Real first = Real(breakpoints[0]), last = Real(breakpoints[pieces]);
        const Real rounding = (last - first) * Real(0x1p-40);
        return !(x < first - rounding) && !(last + rounding < x) && !math::is_not_a_number(x);
    }

    // Where x lies; beyond the first and the last piece in these.
    template <class Real> [[nodiscard]] std::size_t piece(const Real& x) const {
        std::size_t first = 0, count = pieces;
        while (count > 1) {
            const std::size_t half = count / 2;
            if (x < Real(breakpoints[first + half])) {
                count = half;
            } else {
                first += half;
                count -= half;
            }
        }
        return first;
    }
};

template <class Real> Real spline(const Spline& of, int derivative, const Real& x) {
    return of.at(derivative, x);
}

template <class Number> Scaled<Number> spline(const Spline& of, int derivative, const Scaled<Number>& x) {
    return of_number([&](const Number& value) { return of.at(derivative, value); }, x);
}

} // namespace resonform

#endif
