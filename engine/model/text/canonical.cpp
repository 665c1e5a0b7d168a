// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/canonical.hpp"

#include "model/text/eps_powers.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

std::string spell_sum(const ex& e) {
    std::vector<std::string> terms;
    for (const ex& term : e) terms.push_back(spell(term));
    std::sort(terms.begin(), terms.end());
    std::string text;
    for (const auto& t : terms) text += (text.empty() ? "" : t.front() == '-' ? " " : " + ") + t;
    return text;
}

// The first term, numbers last, is negative. Signs are those of the spelling: of a/(b - c) the library may
// hold -a/(c - b).
bool begins_negative(const ex& sum) {
    std::pair<bool, std::string> lowest{true, {}};
    bool negative = false;
    for (std::size_t k = 0; k < sum.nops(); ++k) {
        const std::string text = spell(sum.op(k));
        const bool minus = text.front() == '-';
        std::pair<bool, std::string> here{is_a<GiNaC::numeric>(sum.op(k)), text.substr(minus ? 1 : 0)};
        if (k > 0 && lowest < here) continue;
        lowest = std::move(here);
        negative = minus;
    }
    return negative;
}

// A power, and whether its sign is to be changed: GiNaC writes (a - b)^(-1) or -(b - a)^(-1) as its
// order of terms has it.
std::pair<std::string, bool> spell_power(const ex& e) {
    const ex &base = e.op(0), exponent = e.op(1);
    const std::string index =
        exponent.info(GiNaC::info_flags::nonnegint) ? spell(exponent) : "(" + spell(exponent) + ")";
    if (is_a<GiNaC::symbol>(base)) {
        if (exponent.info(GiNaC::info_flags::rational))
            if (auto text = spell_eps_power(ex_to<GiNaC::symbol>(base), ex_to<GiNaC::numeric>(exponent)))
                return {*text, false};
        return {spell(base) + "^" + index, false};
    }
    const bool whole = is_a<GiNaC::add>(base) && exponent.info(GiNaC::info_flags::integer);
    const ex shown = whole ? canonical_sign(base) : base;
    return {"(" + spell(shown) + ")^" + index,
            exponent.info(GiNaC::info_flags::odd) && !shown.is_equal(base)};
}

// A factor of a product, and whether the sign of the product is to be changed.
std::pair<std::string, bool> spell_factor(const ex& e) {
    if (is_a<GiNaC::power>(e)) return spell_power(e);
    if (!is_a<GiNaC::add>(e)) return {spell(e), false};
    return {"(" + spell(canonical_sign(e)) + ")", begins_negative(e)};
}

std::string spell_product(const ex& e) {
    ex number = 1;
    std::vector<std::string> factors;
    for (const ex& factor : e) {
        if (is_a<GiNaC::numeric>(factor)) {
            number *= factor;
        } else {
            const auto [text, negative] = spell_factor(factor);
            factors.push_back(text);
            if (negative) number = -number;
        }
    }
    std::sort(factors.begin(), factors.end());
    std::string text;
    for (const auto& f : factors) text += (text.empty() ? "" : "*") + f;
    if (number.is_equal(1)) return text;
    return (number.is_equal(-1) ? "-" : spell(number) + "*") + text;
}

} // namespace

std::string spell(const ex& e) {
    if (is_a<GiNaC::add>(e)) return spell_sum(e);
    if (is_a<GiNaC::mul>(e)) return spell_product(e);
    if (is_a<GiNaC::power>(e)) {
        const auto [text, negative] = spell_power(e);
        return (negative ? "-" : "") + text;
    }
    if (is_named(e)) {
        const NamedCall call = named_call(e);
        return call.name + std::string(static_cast<std::size_t>(call.derivative), '\'') + "(" +
               spell(call.argument) + ")";
    }
    if (is_a<GiNaC::function>(e)) return ex_to<GiNaC::function>(e).get_name() + "(" + spell(e.op(0)) + ")";
    if (e.is_equal(GiNaC::Pi)) return "pi";
    std::ostringstream stream;
    stream << e;
    return stream.str();
}

std::vector<ex> operands(const ex& e) {
    if (!is_a<GiNaC::add>(e) && !is_a<GiNaC::mul>(e)) return {e.begin(), e.end()};
    std::vector<std::pair<std::string, ex>> spelled;
    for (const ex& operand : e) spelled.emplace_back(spell(operand), operand);
    std::sort(spelled.begin(), spelled.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<ex> sorted;
    for (auto& entry : spelled) sorted.push_back(std::move(entry.second));
    return sorted;
}

bool holds_functions_or_roots(const ex& e) {
    return std::any_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
        return is_a<GiNaC::function>(part) ||
               (is_a<GiNaC::power>(part) && !part.op(1).info(GiNaC::info_flags::integer));
    });
}

ex canonical_sign(const ex& sum) { return begins_negative(sum) ? (-sum).expand() : sum; }

std::vector<ex> terms_of(const ex& e) { return is_a<GiNaC::add>(e) ? operands(e) : std::vector<ex>{e}; }

std::vector<ex> factors_of(const ex& e) { return is_a<GiNaC::mul>(e) ? operands(e) : std::vector<ex>{e}; }

Rational to_rational(const ex& number) {
    return cln::the<cln::cl_RA>(ex_to<GiNaC::numeric>(number).to_cl_N());
}

ex to_ginac(const Rational& number) { return GiNaC::numeric(number); }

} // namespace resonform
