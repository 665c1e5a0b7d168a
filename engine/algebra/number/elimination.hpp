// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations over a field by Gauss and Jordan, for every kind of entry.
//
//   (A | B)  ->  (R | C),   R the reduced row echelon form of A,   A X = B  <=>  R X = C
//
// A pivot must be proved non-zero. The arithmetic of the entries comes from a class with
//   Zero zero(a)                                the zero test that pivots are chosen by
//   bool is_zero(a)                             a cheap test; false for a zero only costs time
//   bool settles(a)                             a is a good pivot: stop searching this column
//   std::optional<Divisor> divisor(a), over(a, divisor)
//   without(a, factor, b)                       a - factor b
#pragma once

#include "algebra/number/zero.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

// The row of the pivot of a column among the rows from `first` on; nullopt: none; `unknown`: there may be
// one.
template <class Entry, class Field>
std::optional<std::size_t> pivot_row(const std::vector<std::vector<Entry>>& rows, std::size_t first,
                                     std::size_t column, const Field& field, bool& unknown) {
    std::optional<std::size_t> pivot;
    for (std::size_t r = first; r < rows.size(); ++r) {
        const Zero zero = field.zero(rows[r][column]);
        unknown = unknown || zero == Zero::unknown;
        if (zero != Zero::no) continue;
        const bool settles = field.settles(rows[r][column]);
        if (!pivot || settles) pivot = r;
        if (settles) break;
    }
    return pivot;
}

// A is the first `columns` columns. The columns of the pivots, row by row: the rows behind are zero in A.
// nullopt: whether a column has a pivot is not known.
template <class Entry, class Field>
std::optional<std::vector<std::size_t>> reduce_rows(std::vector<std::vector<Entry>>& rows,
                                                    std::size_t columns, const Field& field) {
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < columns && pivots.size() < rows.size(); ++column) {
        const std::size_t row = pivots.size();
        bool unknown = false;
        const auto pivot = pivot_row(rows, row, column, field, unknown);
        if (!pivot && unknown) return std::nullopt;
        if (!pivot) continue;
        std::swap(rows[row], rows[*pivot]);
        std::vector<Entry>& by = rows[row];
        const auto divisor = field.divisor(by[column]);
        if (!divisor) return std::nullopt;
        for (std::size_t k = column; k < by.size(); ++k) by[k] = field.over(by[k], *divisor);
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const Entry factor = rows[r][column];
            if (r == row || field.is_zero(factor)) continue;
            for (std::size_t k = column; k < by.size(); ++k)
                if (!field.is_zero(by[k])) rows[r][k] = field.without(rows[r][k], factor, by[k]);
        }
        pivots.push_back(column);
    }
    return pivots;
}

// X for a square A, in place of (A | B). False: A is not proved to be regular.
template <class Entry, class Field>
bool solve_rows(std::vector<std::vector<Entry>>& rows, const Field& field) {
    const auto pivots = reduce_rows(rows, rows.size(), field);
    if (!pivots || pivots->size() != rows.size()) return false;
    const auto width = static_cast<std::ptrdiff_t>(rows.size());
    for (std::vector<Entry>& row : rows) row.erase(row.begin(), row.begin() + width);
    return true;
}

// A^-1, likewise.
template <class Entry, class Field>
std::optional<std::vector<std::vector<Entry>>> inverse_rows(std::vector<std::vector<Entry>> a,
                                                            const Entry& one, const Field& field) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0, n = a.size(); j < n; ++j) a[i].push_back(i == j ? one : Entry{});
    if (!solve_rows(a, field)) return std::nullopt;
    return a;
}

} // namespace resonform
