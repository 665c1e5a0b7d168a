// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace resonform {

namespace {

std::string text_of(const GiNaC::ex& e) {
    std::ostringstream out;
    out << e;
    return out.str();
}

bool is_odd_integer(const GiNaC::ex& e) {
    return GiNaC::is_a<GiNaC::numeric>(e) && GiNaC::ex_to<GiNaC::numeric>(e).is_odd();
}
bool is_whole(const GiNaC::ex& e) {
    return GiNaC::is_a<GiNaC::numeric>(e) && GiNaC::ex_to<GiNaC::numeric>(e).is_integer();
}

} // namespace

const SignedSpelling::Form& SignedSpelling::of(const GiNaC::ex& e) {
    const auto found = forms_.find(e);
    if (found != forms_.end()) return found->second;
    Form own = form(e);
    return forms_.emplace(e, std::move(own)).first->second;
}

std::string SignedSpelling::with_sign(const GiNaC::ex& e) {
    const Form& form = of(e);
    return (form.negative ? "-" : "") + form.text;
}

std::vector<GiNaC::ex> SignedSpelling::sorted_operands(const GiNaC::ex& e) {
    std::vector<GiNaC::ex> operands(e.begin(), e.end());
    std::sort(operands.begin(), operands.end(),
              [this](const GiNaC::ex& a, const GiNaC::ex& b) { return of(a).text < of(b).text; });
    return operands;
}

SignedSpelling::Form SignedSpelling::form(const GiNaC::ex& e) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) {
        const bool negative = GiNaC::ex_to<GiNaC::numeric>(e).is_negative();
        return {negative, text_of(negative ? GiNaC::ex(-e) : e)};
    }
    if (GiNaC::is_a<GiNaC::symbol>(e)) return {false, name_(GiNaC::ex_to<GiNaC::symbol>(e))};
    if (GiNaC::is_a<GiNaC::add>(e)) return of_sum(e);
    if (GiNaC::is_a<GiNaC::mul>(e)) return of_product(e);
    if (GiNaC::is_a<GiNaC::power>(e)) return of_power(e);
    if (e.nops() == 0) return {false, text_of(e)};
    std::string text =
        "(" + (GiNaC::is_a<GiNaC::function>(e) ? GiNaC::ex_to<GiNaC::function>(e).get_name() : text_of(e));
    for (const GiNaC::ex& operand : e) text += " " + with_sign(operand);
    return {false, text + ")"};
}

SignedSpelling::Form SignedSpelling::of_sum(const GiNaC::ex& e) {
    const std::vector<GiNaC::ex> terms = sorted_operands(e);
    Form result{of(terms.front()).negative, "(+"};
    for (const GiNaC::ex& term : terms)
        result.text += (of(term).negative == result.negative ? " " : " -") + of(term).text;
    result.text += ")";
    return result;
}

// -1 is but a sign, and -x is spelled as x is.
SignedSpelling::Form SignedSpelling::of_product(const GiNaC::ex& e) {
    Form result;
    std::vector<std::string> factors;
    for (const GiNaC::ex& factor : sorted_operands(e)) {
        result.negative ^= of(factor).negative;
        if (of(factor).text != "1") factors.push_back(of(factor).text);
    }
    if (factors.size() == 1)
        result.text = factors.front();
    else
        result.text = fmt::format("(* {})", fmt::join(factors, " "));
    return result;
}

SignedSpelling::Form SignedSpelling::of_power(const GiNaC::ex& e) {
    const std::string exponent = " " + with_sign(e.op(1)) + ")";
    if (!is_whole(e.op(1))) return {false, "(^ " + with_sign(e.op(0)) + exponent};
    return {is_odd_integer(e.op(1)) && of(e.op(0)).negative, "(^ " + of(e.op(0)).text + exponent};
}

} // namespace resonform
