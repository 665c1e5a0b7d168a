// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/equation_texts.hpp"

#include "model/exact/written_form.hpp"
#include "model/text/canonical.hpp"
#include "model/text/expression.hpp"
#include "model/text/growth.hpp"

#include <algorithm>

namespace resonform {

using GiNaC::ex;

namespace {

// Exact forms that fit in texts, or residuals that fit in none as they are.
bool are_worth_exact_form(const std::vector<ex>& residuals) {
    constexpr double shortest_term = 10; // bytes
    double exact = 0, as_put_in = 0;
    for (const ex& residual : residuals) {
        exact = std::max(exact, terms_in_exact_form(residual));
        as_put_in = std::max(as_put_in, of_expression(residual).terms);
    }
    return exact * shortest_term <= static_cast<double>(Limits{}.length) || as_put_in > Limits{}.terms;
}

} // namespace

std::vector<std::string> EquationTexts::rates_of(const std::vector<ex>& residuals,
                                                 const std::vector<GiNaC::symbol>& unknowns) {
    if (!are_worth_exact_form(residuals)) return {};
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        const ex residual = form_.simplified(residuals[i]), slope = residual.diff(unknowns[i]);
        if (!slope.is_equal(1) && !slope.is_equal(-1)) return {};
        const ex rate = form_.simplified(unknowns[i] - residual / slope);
        if (std::any_of(unknowns.begin(), unknowns.end(), [&](const auto& u) { return rate.has(u); }))
            return {};
        texts.push_back(unknowns[i].get_name() + " = " + written(form_, rate));
    }
    return texts;
}

std::vector<std::string> EquationTexts::of(const std::vector<ex>& residuals,
                                           const std::vector<GiNaC::symbol>& unknowns) {
    if (are_worth_exact_form(residuals)) return of_exact(residuals, unknowns);
    std::vector<std::string> texts;
    for (const ex& residual : residuals) texts.push_back(spell(residual) + " = 0");
    return texts;
}

std::vector<std::string> EquationTexts::of_exact(std::vector<ex> residuals,
                                                 const std::vector<GiNaC::symbol>& unknowns) {
    for (ex& residual : residuals) residual = form_.simplified(residual);
    std::vector<std::string> texts = solved(rows_of(residuals, unknowns), unknowns);
    if (texts.empty())
        for (const ex& residual : residuals)
            texts.push_back(written(form_, without_content(residual)) + " = 0");
    return texts;
}

// Solved for the unknowns; empty where the equations are not coupled, or a solution is too long.
std::vector<std::string> EquationTexts::solved(const std::vector<ExactRow>& rows,
                                               const std::vector<GiNaC::symbol>& unknowns) {
    bool coupled = false;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < unknowns.size(); ++k)
            coupled = coupled || (i != k && form_.vanishes(rows[i][k]) != Zero::yes);
    if (!coupled) return {};
    std::vector<std::string> texts;
    for (const ex& solution : solve_if_short(rows, form_, place_)) {
        texts.push_back(unknowns[texts.size()].get_name() + " = " + written(form_, solution));
        if (texts.back().size() > Limits{}.length || of_expression(solution).terms > Limits{}.terms)
            return {};
    }
    return texts;
}

std::vector<ExactRow> EquationTexts::rows_of(const std::vector<ex>& residuals,
                                             const std::vector<GiNaC::symbol>& unknowns) {
    GiNaC::exmap none;
    for (const GiNaC::symbol& unknown : unknowns) none[unknown] = 0;
    std::vector<ExactRow> rows;
    for (const ex& residual : residuals) {
        ExactRow row;
        for (const GiNaC::symbol& unknown : unknowns) row.push_back(form_.simplified(residual.diff(unknown)));
        row.push_back(form_.simplified(-residual.subs(none, GiNaC::subs_options::no_pattern)));
        rows.push_back(std::move(row));
    }
    return rows;
}

ex EquationTexts::without_content(const ex& residual) {
    const ExactForm::Fraction f = form_.fraction(residual);
    if (f.numerator.is_zero()) return residual;
    const bool moves = std::any_of(form_.generators().begin(), form_.generators().end(), [&](const auto& g) {
        return g.kind <= ExactForm::Kind::rate && f.denominator.has(g.symbol);
    });
    if (moves) return without_content(form_.meaning(f.numerator));
    ex factor = f.denominator.integer_content() / f.numerator.integer_content();
    const auto divide_by = [&](const ex& symbol) {
        factor *= GiNaC::pow(symbol, f.denominator.ldegree(symbol) - f.numerator.ldegree(symbol));
    };
    divide_by(system_.eps);
    for (const Parameter& p : system_.parameters)
        if (p.nonzero) divide_by(p.symbol);
    for (const Variable& v : system_.variables)
        if (v.nonzero) divide_by(v.jet.front());
    return form_.simplified(residual * factor);
}

} // namespace resonform
