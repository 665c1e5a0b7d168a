// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/rational_matrix.hpp"

#include "algebra/number/elimination.hpp"

namespace resonform {

namespace {

void scale_rows(RationalMatrix& m, const std::vector<Rational>& by) {
    for (std::size_t r = 0; r < m.rows(); ++r)
        for (std::size_t c = 0; c < m.columns(); ++c) m.at(r, c) = m.at(r, c) * by[r];
}

} // namespace

RationalMatrix multiply(const RationalMatrix& a, const RationalMatrix& b) {
    RationalMatrix product(a.rows(), b.columns());
    for (std::size_t r = 0; r < a.rows(); ++r)
        for (std::size_t k = 0; k < a.columns(); ++k) {
            if (cln::zerop(a.at(r, k))) continue;
            for (std::size_t c = 0; c < b.columns(); ++c)
                if (!cln::zerop(b.at(k, c))) product.at(r, c) = product.at(r, c) + a.at(r, k) * b.at(k, c);
        }
    return product;
}

RationalMatrix transposed(const RationalMatrix& a) {
    RationalMatrix result(a.columns(), a.rows());
    for (std::size_t r = 0; r < a.rows(); ++r)
        for (std::size_t c = 0; c < a.columns(); ++c) result.at(c, r) = a.at(r, c);
    return result;
}

RationalMatrix solve(const RationalMatrix& a, const RationalMatrix& b) {
    std::vector<std::vector<Rational>> rows(a.rows());
    for (std::size_t r = 0; r < a.rows(); ++r) {
        for (std::size_t c = 0; c < a.columns(); ++c) rows[r].push_back(a.at(r, c));
        for (std::size_t c = 0; c < b.columns(); ++c) rows[r].push_back(b.at(r, c));
    }
    const auto pivots = reduce_rows(rows, a.columns(), Rationals());
    RationalMatrix x(a.columns(), b.columns());
    for (std::size_t row = 0; row < pivots->size(); ++row)
        for (std::size_t c = 0; c < b.columns(); ++c) x.at((*pivots)[row], c) = rows[row][a.columns() + c];
    return x;
}

RationalMatrix pseudo_inverse(const RationalMatrix& b, const std::vector<Rational>& rows,
                              const std::vector<Rational>& columns) {
    RationalMatrix measured = b; // G_r B
    scale_rows(measured, rows);
    RationalMatrix adjoint = transposed(b); // G_c^-1 B^T
    std::vector<Rational> inverses;
    for (const Rational& c : columns) inverses.push_back(1 / c);
    scale_rows(adjoint, inverses);
    const RationalMatrix right = transposed(measured); // B^T G_r
    return multiply(adjoint, solve(multiply(right, multiply(b, adjoint)), right));
}

} // namespace resonform
