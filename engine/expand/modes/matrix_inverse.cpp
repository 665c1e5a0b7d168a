// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/matrix_inverse.hpp"

#include "algebra/number/elimination.hpp"
#include "model/text/expression_field.hpp"
#include "model/text/zero_test.hpp"

#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;

bool is_number(const ex& a) { return GiNaC::is_a<GiNaC::numeric>(a); }

// Numbers are the best pivots: expressions do not grow.
struct Expressions : ExpressionField {
    static Zero zero(const ex& a) { return vanishes(a); }
    static bool settles(const ex& a) { return is_number(a); }
};
struct ComplexExpressions {
    static Zero zero(const Complex& a) {
        const Zero re = vanishes(a.re);
        if (re == Zero::no) return re;
        const Zero im = vanishes(a.im);
        return im == Zero::yes ? re : im;
    }
    static bool is_zero(const Complex& a) { return a.is_zero(); }
    static bool settles(const Complex& a) { return is_number(a.re) && is_number(a.im); }
    static std::optional<Complex> divisor(const Complex& a) { return a; }
    static Complex over(const Complex& a, const Complex& b) { return normal(a / b); }
    static Complex without(const Complex& a, const Complex& factor, const Complex& b) {
        return normal(a - factor * b);
    }
};

} // namespace

std::optional<Matrix> inverse(Matrix a) { return inverse_rows(std::move(a), ex(1), Expressions()); }

std::optional<std::vector<Complex>> solve_linear(std::vector<std::vector<Complex>> a,
                                                 std::vector<Complex> right) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i].push_back(right[i]);
    if (!solve_rows(a, ComplexExpressions())) return std::nullopt;
    for (std::size_t i = 0; i < a.size(); ++i) right[i] = a[i].front();
    return right;
}

} // namespace resonform
