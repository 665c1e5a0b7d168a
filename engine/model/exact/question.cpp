// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/question.hpp"

#include "model/exact/form.hpp"
#include "model/text/canonical.hpp"
#include "model/text/growth.hpp"

#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;

constexpr double most_terms_in_a_question = 1000; // larger ones take too long: a derivation asks often

bool is_worth_converting(const ex& e) {
    return holds_functions_or_roots(e) && terms_in_exact_form(e) <= most_terms_in_a_question;
}

ExactForm form_of(const System& system) {
    ExactForm form(system);
    form.add(system.eps, ExactForm::Kind::eps);
    for (const Parameter& p : system.parameters) form.add(p.symbol, ExactForm::Kind::parameter);
    for (const Variable& v : system.variables)
        for (const GiNaC::symbol& symbol : v.jet) form.add(symbol, ExactForm::Kind::slow);
    return form;
}

} // namespace

Zero vanishes(const ex& e, const System& system) {
    std::vector<ex> positive;
    for (const Declaration& declared : system.positive) positive.push_back(declared.value);
    const Zero zero = vanishes(e, positive);
    if (zero != Zero::unknown || !is_worth_converting(e)) return zero;
    try {
        return form_of(system).vanishes(e) == Zero::yes ? Zero::yes : Zero::unknown;
    } catch (const Error&) { // exact form has no root of something that may be negative
        return Zero::unknown;
    }
}

} // namespace resonform
