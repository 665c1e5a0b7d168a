// SPDX-License-Identifier: GPL-3.0-or-later
// A polynomial in each of several intervals side by side, its numbers doubles, which are exact: all who
// evaluate it see the same function.
//
//   S(x) = sum_j c[k][j] (x - x_k)^j    on  x_k <= x < x_{k+1},  k = 0 ... pieces - 1
#pragma once

#include "algebra/number/number.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

struct PiecewisePolynomial {
    std::string name; // of the function that it is the value of
    int degree = 0;
    std::vector<double> breakpoints;  // ascending, of the first piece to the end of the last
    std::vector<double> coefficients; // degree + 1 of each piece, ascending

    [[nodiscard]] std::size_t pieces() const { return breakpoints.size() - 1; }
    [[nodiscard]] bool holds(const Rational& x) const; // whether x is in their range
    // The derivative-th derivative. Precondition: holds(x).
    [[nodiscard]] Rational at(const Rational& x, int derivative) const;
    // 1 or -1 if all values have this sign, proved exactly; 0: they have not, or nearly not.
    [[nodiscard]] int sign() const;
    // Every number, the same in every run: for the keys of caches.
    [[nodiscard]] std::string text() const;
};

using DataPointer = std::shared_ptr<const PiecewisePolynomial>;

} // namespace resonform
