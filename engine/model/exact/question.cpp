// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/question.hpp"

#include "model/exact/form.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"
#include "model/text/growth.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;

constexpr double most_terms_in_a_question = 1000; // larger ones take too long: a derivation asks often

bool is_small(const ex& e) { return terms_in_exact_form(e) <= most_terms_in_a_question; }

bool is_worth_converting(const ex& e) { return holds_functions_or_roots(e) && is_small(e); }

bool is_small_quotient(const ex& e) {
    return is_small(e) && std::any_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
               return GiNaC::is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::negative);
           });
}

// 1 + tau/k is as positive as k + tau, where k is: where e or a declaration is a quotient, it is numerators
// that are compared.
bool is_worth_asking(const ex& e, const System& system) {
    if (is_worth_converting(e)) return true;
    if (system.positive.empty() || !is_small(e)) return false;
    return is_small_quotient(e) ||
           std::any_of(system.positive.begin(), system.positive.end(),
                       [](const Declaration& declared) { return is_small_quotient(declared.value); });
}

ExactForm form_of(const System& system) {
    ExactForm form(system);
    form.add(system.eps, ExactForm::Kind::eps);
    for (const Parameter& p : system.parameters) form.add(p.symbol, ExactForm::Kind::parameter);
    for (const Variable& v : system.variables)
        for (const GiNaC::symbol& symbol : v.jet) form.add(symbol, ExactForm::Kind::slow);
    return form;
}

std::vector<ex> factorised(const ex& polynomial) {
    const bool factors =
        polynomial.nops() <= largest_compared && polynomial.info(GiNaC::info_flags::rational_polynomial);
    const ex factored = factors ? GiNaC::factor(polynomial) : polynomial;
    return factors_of(factored);
}

// The factors of numerator and denominator whose sign is not known. `declared`: it is positive, so that no
// factor is zero.
ex of_equal_sign(const ex& e, ExactForm& form, const SignProver& prover, bool declared) {
    const ExactForm::Fraction f = form.fraction(e);
    const ProvedSign least = declared ? ProvedSign::nonnegative : ProvedSign::positive;
    ex result = 1;
    for (const ex& polynomial : {f.numerator, f.denominator})
        for (const ex& factor : factorised(polynomial)) {
            const ex value = form.meaning(factor).expand();
            if (prover.sign(value) >= least) continue;
            result *= prover.sign((-value).expand()) >= least ? ex(-1) : value;
        }
    result = result.expand();
    return result.is_zero() ? result : (result / result.integer_content()).expand();
}

// Hyperbolic functions by exponentials.
struct Exponentials : GiNaC::map_function {
    ex operator()(const ex& e) override {
        ex mapped = e.map(*this);
        const std::optional<Function> f = function_of(mapped);
        if (!f) return mapped;
        const ex up = GiNaC::exp(mapped.op(0)), down = GiNaC::exp(-mapped.op(0));
        if (f == Function::hyperbolic_sine) return (up - down) / 2;
        if (f == Function::hyperbolic_cosine) return (up + down) / 2;
        return f == Function::hyperbolic_tangent ? (up - down) / (up + down) : mapped;
    }
};

// The common denominator of the multiples of names in arguments of functions: 6 for sin(tau/2) + cos(tau/3).
GiNaC::numeric denominator_of_arguments(const ex& e) {
    GiNaC::numeric denominator = 1;
    for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i) {
        if (!GiNaC::is_a<GiNaC::function>(*i) || is_named(*i)) continue;
        const ex content = i->op(0).expand().integer_content();
        denominator = GiNaC::lcm(denominator, GiNaC::ex_to<GiNaC::numeric>(content).denom());
    }
    return denominator;
}

// Every name times this number, which leaves open what signs there are.
GiNaC::exmap stretched(const System& system, const GiNaC::numeric& by) {
    GiNaC::exmap names;
    for (const Parameter& p : system.parameters) names[p.symbol] = by * p.symbol;
    for (const Variable& v : system.variables) names[v.jet.front()] = by * v.jet.front();
    return names;
}

// What domains and signs are made of; equations are left out.
System domain_of(const System& system) {
    System domain;
    domain.parameters = system.parameters;
    domain.variables = system.variables;
    domain.functions = system.functions;
    domain.positive = system.positive;
    domain.eps = system.eps;
    return domain;
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

std::optional<ExactQuestion> exact_question(const ex& e, const System& system) {
    if (!is_worth_asking(e, system)) return std::nullopt;
    Exponentials exponentials;
    ExactQuestion question{domain_of(system), exponentials(e)};
    GiNaC::numeric denominator = denominator_of_arguments(question.asked);
    for (Declaration& declared : question.domain.positive) {
        declared.value = exponentials(declared.value);
        denominator = GiNaC::lcm(denominator, denominator_of_arguments(declared.value));
    }
    const GiNaC::exmap names = stretched(system, denominator);
    const auto stretch = [&](ex& value) { value = value.subs(names, GiNaC::subs_options::no_pattern); };
    if (!denominator.is_equal(1)) {
        stretch(question.asked);
        for (Declaration& declared : question.domain.positive) stretch(declared.value);
    }
    try {
        const SignProver prover(question.domain);
        ExactForm form = form_of(question.domain);
        question.asked = of_equal_sign(question.asked, form, prover, false);
        std::vector<Declaration> exact;
        for (const Declaration& declared : question.domain.positive)
            if (is_worth_converting(declared.value) || is_small_quotient(declared.value))
                exact.push_back(
                    {of_equal_sign(declared.value, form, prover, true), declared.text, declared.source});
        std::move(exact.begin(), exact.end(), std::back_inserter(question.domain.positive));
        return question;
    } catch (const Error&) {
        return std::nullopt;
    }
}

} // namespace resonform
