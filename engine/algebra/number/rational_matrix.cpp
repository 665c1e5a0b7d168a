// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/rational_matrix.hpp"

namespace resonform {

namespace {

void swap_rows(RationalMatrix& m, std::size_t p, std::size_t q) {
    if (p == q) return;
    for (std::size_t k = 0; k < m.columns(); ++k) std::swap(m.at(p, k), m.at(q, k));
}

void add_row(RationalMatrix& m, std::size_t to, std::size_t from, const Rational& factor) {
    for (std::size_t k = 0; k < m.columns(); ++k)
        if (!cln::zerop(m.at(from, k))) m.at(to, k) = m.at(to, k) + factor * m.at(from, k);
}

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

// Gauss and Jordan.
RationalMatrix solve(RationalMatrix a, RationalMatrix b) {
    std::vector<std::pair<std::size_t, Rational>> pivots; // column and entry of the pivot of each row
    for (std::size_t column = 0; column < a.columns() && pivots.size() < a.rows(); ++column) {
        const std::size_t row = pivots.size();
        std::size_t found = row;
        while (found < a.rows() && cln::zerop(a.at(found, column))) ++found;
        if (found == a.rows()) continue;
        swap_rows(a, row, found);
        swap_rows(b, row, found);
        const Rational pivot = a.at(row, column);
        for (std::size_t r = 0; r < a.rows(); ++r) {
            if (r == row || cln::zerop(a.at(r, column))) continue;
            const Rational factor = -a.at(r, column) / pivot;
            add_row(a, r, row, factor);
            add_row(b, r, row, factor);
        }
        pivots.emplace_back(column, pivot);
    }
    RationalMatrix x(a.columns(), b.columns());
    for (std::size_t row = 0; row < pivots.size(); ++row)
        for (std::size_t c = 0; c < b.columns(); ++c)
            x.at(pivots[row].first, c) = b.at(row, c) / pivots[row].second;
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
