// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/spelling.hpp"

#include "emit/display/decimal.hpp"
#include "emit/display/powers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <iterator>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using FactorKind = DisplayFactor::Kind;

bool is_integer(const Rational& value) { return cln::denominator(value) == 1; }

std::string primed(const std::string& name, int primes) {
    return name + std::string(static_cast<std::size_t>(primes), '\'');
}

// A trailing "_" avoids reserved names of the language, and names of the user that end in "_" as well.
template <std::size_t N>
std::string unreserved(const std::array<const char*, N>& reserved, const std::string& name, int primes) {
    const std::string stem = name.substr(0, name.find_last_not_of('_') + 1);
    const bool taken = std::find(reserved.begin(), reserved.end(), stem) != reserved.end();
    std::string safe = taken ? name + "_" : name;
    for (int i = 0; i < primes; ++i) safe += "_dot";
    return safe;
}

// Avoids names that the script imports or sets. Keywords of Python are no names in system files.
std::string python_symbol(const std::string& name, int primes) {
    static constexpr std::array<const char*, 12> reserved = {"Rational",
                                                             "Symbol",
                                                             "prod",
                                                             "main",
                                                             "print",
                                                             "series",
                                                             "sum",
                                                             "zip",
                                                             "variables",
                                                             "normal_form",
                                                             "near_identity_map",
                                                             "Function"};
    return unreserved(reserved, name, primes);
}

std::string maxima_symbol(const std::string& name, int primes) {
    if (name == "pi") return "%pi"; // the number: no user has the name
    static constexpr std::array<const char*, 20> reserved = {
        "if",   "then", "else", "elseif", "do", "for", "while", "unless",        "from",   "step",
        "next", "thru", "in",   "and",    "or", "not", "rate",  "old_minus_new", "assume", "sqrt"};
    return unreserved(reserved, name, primes);
}

std::string sympy_integral(const std::string& integrand, const std::string& variable, const std::string& from,
                           const std::string& to) {
    return fmt::format("Integral({}, ({}, {}, {}))", integrand, variable, from, to);
}

std::string text_integral(const std::string& integrand, const std::string& variable, const std::string& from,
                          const std::string& to) {
    return fmt::format("integral({}, {} = {}..{})", integrand, variable, from, to);
}

std::string maxima_integral(const std::string& integrand, const std::string& variable,
                            const std::string& from, const std::string& to) {
    return fmt::format("integrate({}, {}, {}, {})", integrand, variable, from, to);
}

bool is_name(const std::string& text) {
    return std::all_of(text.begin(), text.end(),
                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

std::string text_derivative(const std::string& function, int order, const std::string& argument) {
    return primed(function, order) + "(" + argument + ")";
}

// At an argument that is no name the derivative is taken first and evaluated then.
std::string sympy_derivative(const std::string& function, int order, const std::string& argument,
                             const std::string& other_variable) {
    const std::string variable = is_name(argument) ? argument : other_variable;
    const std::string by = order == 1 ? variable : fmt::format("({}, {})", variable, order);
    const std::string derivative = fmt::format("Derivative({}({}), {})", function, variable, by);
    return is_name(argument) ? derivative : fmt::format("Subs({}, {}, {})", derivative, variable, argument);
}

std::string json_derivative(const std::string& function, int order, const std::string& argument) {
    return sympy_derivative(function, order, argument, "_u");
}

std::string python_derivative(const std::string& function, int order, const std::string& argument) {
    return sympy_derivative(function, order, argument, "Symbol(\"u\")");
}

std::string maxima_derivative(const std::string& function, int order, const std::string& argument) {
    const std::string variable = is_name(argument) ? argument : "u_";
    const std::string derivative = fmt::format("'diff({}({}), {}, {})", function, variable, variable, order);
    return is_name(argument) ? derivative : fmt::format("at({}, {} = {})", derivative, variable, argument);
}

std::string rational(const Rational& value, const Spelling& spelling) {
    if (is_integer(value) || !spelling.wrapped_rational) return to_string(value);
    return fmt::format("Rational({}, {})", to_string(Rational(cln::numerator(value))),
                       to_string(Rational(cln::denominator(value))));
}

// a, or (-a/2)
std::string symbolic_exponent(const DisplaySum& exponent, const Spelling& spelling) {
    const std::string text = spell(exponent, spelling);
    const bool name = std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c); });
    return name ? text : "(" + text + ")";
}

std::string function(const DisplayFactor& factor, const Spelling& spelling) {
    const std::string argument = spell(factor.arguments.front(), spelling);
    const std::string name = is_elementary(factor) ? factor.name : spelling.symbol(factor.name, 0);
    if (factor.primes > 0) return spelling.derivative(name, factor.primes, argument);
    return name + "(" + argument + ")";
}

// The base without parentheses around it.
std::string inner(const DisplayFactor& factor, const Spelling& spelling) {
    switch (factor.kind) {
    case FactorKind::symbol: return spelling.symbol(factor.name, factor.primes);
    case FactorKind::number: return rational(factor.number, spelling);
    case FactorKind::sum: return spell(factor.arguments.front(), spelling);
    case FactorKind::function: return function(factor, spelling);
    case FactorKind::integral:
        return spelling.integral(spell(factor.arguments[0], spelling), spell(factor.arguments[1], spelling),
                                 spell(factor.arguments[2], spelling), spell(factor.arguments[3], spelling));
    case FactorKind::power:
        return spell(factor.arguments[0].terms.front().factors.front(), spelling) + spelling.power +
               symbolic_exponent(factor.arguments[1], spelling);
    }
    return {};
}

bool needs_parentheses(const DisplayFactor& factor) {
    return factor.kind == FactorKind::sum ||
           (factor.kind == FactorKind::number && !is_integer(factor.number));
}

std::string power(const DisplayFactor& factor, const Rational& exponent, const Spelling& spelling) {
    std::string base = inner(factor, spelling);
    const bool has_root = factor.kind != FactorKind::sum || spelling.root_of_sums;
    if (has_root && exponent == Rational(1) / 2) return "sqrt(" + base + ")";
    std::string atom = needs_parentheses(factor) ? "(" + base + ")" : std::move(base);
    if (exponent == 1) return atom;
    const std::string spelled = rational(exponent, spelling);
    const bool plain = is_integer(exponent) && exponent > 0;
    return atom + spelling.power + (plain || spelling.wrapped_rational ? spelled : "(" + spelled + ")");
}

std::string product(const std::vector<std::string>& factors) {
    std::string text;
    for (const std::string& factor : factors) {
        if (!text.empty()) text += '*';
        text += factor;
    }
    return text;
}

// |coefficient| * [i] * factors: "sqrt(g)/(4*r)"; empty for 1 when a tail follows.
std::string fraction(const DisplayTerm& term, const Spelling& spelling) {
    const Rational size = cln::abs(term.coefficient);
    std::vector<std::string> above, below;
    if (term.digits > 0) {
        if (size != 1) above.push_back(decimal(size, term.digits));
    } else if (cln::numerator(size) != 1) {
        above.push_back(to_string(Rational(cln::numerator(size))));
    }
    if (term.digits == 0 && cln::denominator(size) != 1)
        below.push_back(to_string(Rational(cln::denominator(size))));
    const bool only_number = !term.imaginary && term.factors.empty();
    if (only_number && !below.empty()) return rational(size, spelling);
    if (term.imaginary) above.emplace_back(spelling.imaginary);
    for (const DisplayFactor& factor : term.factors)
        (factor.exponent > 0 ? above : below).push_back(power(factor, cln::abs(factor.exponent), spelling));
    if (above.empty()) {
        if (below.empty() && !term.tail.empty()) return {};
        above.emplace_back("1");
    }
    if (below.empty()) return product(above);
    const std::string denominator = product(below);
    return product(above) + "/" + (below.size() == 1 ? denominator : "(" + denominator + ")");
}

std::string spell_unsigned(const DisplayTerm& term, const Spelling& spelling) {
    std::vector<std::string> factors;
    if (std::string head = fraction(term, spelling); !head.empty()) factors.push_back(std::move(head));
    for (const DisplayFactor& factor : term.tail) factors.push_back(power(factor, factor.exponent, spelling));
    return product(factors);
}

} // namespace

const Spelling& text_spelling() {
    static const Spelling spelling{"^", "I", true, false, primed, text_derivative, text_integral};
    return spelling;
}

const Spelling& json_spelling() {
    static const Spelling spelling{"**", "I", false, false, primed, json_derivative, sympy_integral};
    return spelling;
}

const Spelling& python_spelling() {
    static const Spelling spelling{"**", "I", true, true, python_symbol, python_derivative, sympy_integral};
    return spelling;
}

const Spelling& maxima_spelling() {
    static const Spelling spelling{"^", "%i", true, false, maxima_symbol, maxima_derivative, maxima_integral};
    return spelling;
}

std::string spell(const DisplaySum& sum, const Spelling& spelling) {
    return signed_sum(sum, [&](const DisplayTerm& term) {
        return is_bare_sum(term) ? inner(term.factors.front(), spelling) : spell_unsigned(term, spelling);
    });
}

std::string spell(const DisplayFactor& factor, const Spelling& spelling) {
    return power(factor, factor.exponent, spelling);
}

} // namespace resonform
