// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/eigen_field.hpp"

#include "algebra/number/elimination.hpp"
#include "expand/modes/matrix_inverse.hpp"
#include "model/text/zero_test.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

std::size_t leading(const EigenField::Row& row) {
    std::size_t k = 0;
    while (EigenField::vanishes(row[k]) == Zero::yes) ++k;
    return k;
}

} // namespace

EigenField::Element EigenField::constant(const ex& value) const {
    Element e(degree());
    e.front() = value;
    return e;
}

EigenField::Element EigenField::root() const {
    if (degree() == 1) return {(-lower_.front()).normal()};
    Element e(degree());
    e[1] = 1;
    return e;
}

EigenField::Element EigenField::minus(const Element& a, const Element& b) const {
    Element e(degree());
    for (std::size_t k = 0; k < e.size(); ++k) e[k] = (a[k] - b[k]).normal();
    return e;
}

EigenField::Element EigenField::times(const Element& a, const Element& b) const {
    const std::size_t n = degree();
    std::vector<ex> product(2 * n - 1);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if (!a[i].is_zero() && !b[j].is_zero()) product[i + j] += a[i] * b[j];
    for (std::size_t top = product.size(); top-- > n;)
        for (std::size_t k = 0; k < n; ++k) product[top - n + k] -= product[top] * lower_[k];
    product.resize(n);
    for (ex& coefficient : product) coefficient = coefficient.normal();
    return product;
}

// x with a x = 1: linear equations for its coefficients.
std::optional<EigenField::Element> EigenField::inverse(const Element& a) const {
    const std::size_t n = degree();
    Matrix multiplication(n, std::vector<ex>(n)); // column k: a lambda^k
    Element power = a;
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < n; ++i) multiplication[i][k] = power[i];
        power = times(power, root());
    }
    const auto inverted = resonform::inverse(std::move(multiplication));
    if (!inverted) return std::nullopt;
    Element e(n);
    for (std::size_t i = 0; i < n; ++i) e[i] = (*inverted)[i].front();
    return e;
}

Zero EigenField::vanishes(const Element& a) {
    Zero result = Zero::yes;
    for (const ex& coefficient : a) {
        const Zero zero = resonform::vanishes(coefficient);
        if (zero == Zero::no) return zero;
        if (zero == Zero::unknown) result = zero;
    }
    return result;
}

namespace {

struct Elements {
    using Element = EigenField::Element;
    const EigenField& field;

    static Zero zero(const Element& a) { return EigenField::vanishes(a); }
    static bool is_zero(const Element& a) { return EigenField::vanishes(a) == Zero::yes; }
    static bool settles(const Element& /*a*/) { return true; }
    [[nodiscard]] std::optional<Element> divisor(const Element& a) const { return field.inverse(a); }
    [[nodiscard]] Element over(const Element& a, const Element& inverse) const {
        return field.times(a, inverse);
    }
    [[nodiscard]] Element without(const Element& a, const Element& factor, const Element& b) const {
        return field.minus(a, field.times(factor, b));
    }
};

} // namespace

std::optional<EigenField::Rows> EigenField::echelon(Rows rows) const {
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    const auto pivots = reduce_rows(rows, columns, Elements{*this});
    if (!pivots) return std::nullopt;
    rows.resize(pivots->size());
    return rows;
}

std::optional<EigenField::Rows> EigenField::null_space(const Rows& m, std::size_t columns) const {
    const auto reduced = echelon(m);
    if (!reduced) return std::nullopt;
    std::vector<std::size_t> pivots;
    for (const Row& row : *reduced) pivots.push_back(leading(row));
    Rows basis;
    for (std::size_t column = 0; column < columns; ++column) {
        if (std::find(pivots.begin(), pivots.end(), column) != pivots.end()) continue;
        Row v(columns, constant(0));
        v[column] = constant(1);
        for (std::size_t k = 0; k < pivots.size(); ++k)
            v[pivots[k]] = minus(constant(0), (*reduced)[k][column]);
        basis.push_back(std::move(v));
    }
    return basis.empty() ? basis : echelon(std::move(basis));
}

} // namespace resonform
