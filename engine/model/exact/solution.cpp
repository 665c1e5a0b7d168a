// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/solution.hpp"

#include "algebra/number/elimination.hpp"
#include "algebra/number/error.hpp"
#include "model/text/expression.hpp"
#include "model/text/expression_field.hpp"
#include "model/text/growth.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using EntryCounts = std::vector<std::vector<double>>;

double sum_length(const ex& sum) {
    return GiNaC::is_a<GiNaC::add>(sum) ? static_cast<double>(sum.nops()) : 1;
}

// How many terms the entries of a row have over one denominator.
std::vector<double> entry_counts(const ExactRow& row, ExactForm& form) {
    std::vector<ExactForm::Fraction> fractions;
    std::vector<ex> denominators;
    double common = 1;
    for (const ex& entry : row) {
        fractions.push_back(form.fraction(entry));
        const ex& below = fractions.back().denominator;
        const bool known = std::any_of(denominators.begin(), denominators.end(),
                                       [&](const ex& d) { return d.is_equal(below); });
        if (known) continue;
        denominators.push_back(below);
        common *= sum_length(below);
    }
    std::vector<double> counts;
    for (const ExactForm::Fraction& f : fractions)
        counts.push_back(
            f.numerator.is_zero() ? 0 : sum_length(f.numerator) * common / sum_length(f.denominator));
    return counts;
}

// The terms of a determinant whose entries have so many; bit k of `chosen` stands for columns[k].
double determinant_terms(const EntryCounts& rows, const std::vector<std::size_t>& columns) {
    const std::size_t n = rows.size();
    std::vector<double> sums(std::size_t{1} << n, 0);
    sums[0] = 1;
    for (std::size_t chosen = 0; chosen + 1 < sums.size(); ++chosen) {
        std::size_t row = 0;
        for (std::size_t bit = 0; bit < n; ++bit) row += chosen >> bit & 1U;
        for (std::size_t bit = 0; bit < n; ++bit)
            if ((chosen >> bit & 1U) == 0)
                sums[chosen | std::size_t{1} << bit] += sums[chosen] * rows[row][columns[bit]];
    }
    return sums.back();
}

// The most terms that an unknown has by Cramer's rule, its fraction multiplied out.
double terms_when_solved(const std::vector<ExactRow>& rows, ExactForm& form) {
    EntryCounts counts;
    for (const ExactRow& row : rows) counts.push_back(entry_counts(row, form));
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < rows.size(); ++k) columns.push_back(k);
    const double below = determinant_terms(counts, columns);
    double most = 0;
    for (std::size_t& column : columns) {
        const std::size_t unknown = std::exchange(column, rows.size());
        most = std::max(most, determinant_terms(counts, columns) * below);
        column = unknown;
    }
    return most;
}

struct InForm : ExpressionField {
    explicit InForm(ExactForm& f) : form(f) {}
    [[nodiscard]] Zero zero(const ex& a) const { return form.vanishes(a); }
    [[nodiscard]] ex over(const ex& a, const ex& b) const { return form.simplified(a / b); }
    [[nodiscard]] ex without(const ex& a, const ex& factor, const ex& b) const {
        return form.simplified(a - factor * b);
    }

    ExactForm& form;
};

} // namespace

std::vector<ex> solve_exactly(std::vector<ExactRow> rows, ExactForm& form, const Place& place) {
    if (!solve_rows(rows, InForm(form)))
        refuse(Reason::undecided, {"the accelerations can be solved for",
                                   "the determinant of their coefficients is not seen to differ from zero",
                                   "simplify the mechanism", place});
    std::vector<ex> solution;
    for (const ExactRow& row : rows) solution.push_back(row.front());
    return solution;
}

std::vector<ex> solve_if_short(std::vector<ExactRow> rows, ExactForm& form, const Place& place) {
    if (terms_when_solved(rows, form) > Limits{}.terms) return {};
    return solve_exactly(std::move(rows), form, place);
}

} // namespace resonform
