// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/matrix_inverse.hpp"

#include "model/text/zero_test.hpp"

#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;

ex times(const ex& a, const ex& b) { return a.is_zero() || b.is_zero() ? ex(0) : a * b; }
Complex times(const Complex& a, const Complex& b) { return a * b; }
ex minus(const ex& a, const ex& b) { return (a - b).normal(); }
Complex minus(const Complex& a, const Complex& b) { return normal(a - b); }
ex over(const ex& a, const ex& b) { return (a / b).normal(); }
Complex over(const Complex& a, const Complex& b) { return normal(a / b); }
bool differs(const ex& a) { return vanishes(a) == Zero::no; }
bool differs(const Complex& a) { return differs(a.re) || differs(a.im); }
bool is_number(const ex& a) { return GiNaC::is_a<GiNaC::numeric>(a); }
bool is_number(const Complex& a) { return is_number(a.re) && is_number(a.im); }

// Gauss and Jordan on a matrix with more columns than rows, until the left part is the unit matrix. Numbers
// are the best pivots: nothing grows.
template <class Entry> bool eliminate(std::vector<std::vector<Entry>>& m) {
    const std::size_t n = m.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = n;
        for (std::size_t i = k; i < n; ++i)
            if (differs(m[i][k]) && (pivot == n || (is_number(m[i][k]) && !is_number(m[pivot][k]))))
                pivot = i;
        if (pivot == n) return false;
        std::swap(m[k], m[pivot]);
        const Entry head = m[k][k];
        for (Entry& entry : m[k]) entry = over(entry, head);
        for (std::size_t i = 0; i < n; ++i) {
            const Entry factor = m[i][k];
            if (i == k || factor.is_zero()) continue;
            for (std::size_t j = k; j < m[i].size(); ++j)
                if (!m[k][j].is_zero()) m[i][j] = minus(m[i][j], times(factor, m[k][j]));
        }
    }
    return true;
}

} // namespace

std::optional<Matrix> inverse(Matrix a) {
    const std::size_t n = a.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) a[i].emplace_back(i == j ? 1 : 0);
    if (!eliminate(a)) return std::nullopt;
    for (auto& row : a) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(n));
    return a;
}

std::optional<std::vector<Complex>> solve_linear(std::vector<std::vector<Complex>> a,
                                                 std::vector<Complex> right) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i].push_back(right[i]);
    if (!eliminate(a)) return std::nullopt;
    for (std::size_t i = 0; i < a.size(); ++i) right[i] = a[i].back();
    return right;
}

} // namespace resonform
