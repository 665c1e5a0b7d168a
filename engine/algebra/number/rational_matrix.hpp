// SPDX-License-Identifier: GPL-3.0-or-later
// Small dense matrices of exact numbers.
#pragma once

#include "algebra/number/number.hpp"
#include "algebra/number/zero.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace resonform {

// The field of elimination.hpp.
struct Rationals {
    static Zero zero(const Rational& a) { return cln::zerop(a) ? Zero::yes : Zero::no; }
    static bool is_zero(const Rational& a) { return cln::zerop(a); }
    static bool settles(const Rational& /*a*/) { return true; }
    static std::optional<Rational> divisor(const Rational& a) { return cln::recip(a); }
    static Rational over(const Rational& a, const Rational& inverse) { return a * inverse; }
    static Rational without(const Rational& a, const Rational& factor, const Rational& b) {
        return a - factor * b;
    }
};

class RationalMatrix {
public:
    RationalMatrix(std::size_t rows, std::size_t columns)
        : rows_(rows), columns_(columns), entries_(rows * columns, Rational(0)) {}

    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] std::size_t columns() const { return columns_; }
    Rational& at(std::size_t row, std::size_t column) { return entries_[row * columns_ + column]; }
    [[nodiscard]] const Rational& at(std::size_t row, std::size_t column) const {
        return entries_[row * columns_ + column];
    }

private:
    std::size_t rows_, columns_;
    std::vector<Rational> entries_;
};

RationalMatrix multiply(const RationalMatrix& a, const RationalMatrix& b);
RationalMatrix transposed(const RationalMatrix& a);
// A solution X of A X = B: unknowns that are free are 0. Precondition: there is a solution.
RationalMatrix solve(const RationalMatrix& a, const RationalMatrix& b);

// The weighted pseudo-inverse B+: of all h that minimise R - B h, h = B+ R is the smallest, measured by
// h|^2 = sum columns_k h_k^2 and |R|^2 = sum rows_k R_k^2 (all > 0). With G the diagonal matrices of these,
//   B+ = G_c^-1 B^T Y,   (B^T G_r B G_c^-1 B^T) Y = B^T G_r.
RationalMatrix pseudo_inverse(const RationalMatrix& b, const std::vector<Rational>& rows,
                              const std::vector<Rational>& columns);

} // namespace resonform
