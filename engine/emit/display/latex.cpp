// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/latex.hpp"

#include "algebra/number/functions.hpp"
#include "emit/display/decimal.hpp"
#include "emit/display/powers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <optional>
#include <vector>

namespace resonform {

namespace {

using FactorKind = DisplayFactor::Kind;

bool is_greek(const std::string& word) {
    static constexpr std::array<const char*, 34> letters = {
        "alpha",   "beta",   "gamma", "delta",   "epsilon", "zeta",  "eta",   "theta", "iota",
        "kappa",   "lambda", "mu",    "nu",      "xi",      "pi",    "rho",   "sigma", "tau",
        "upsilon", "phi",    "chi",   "psi",     "omega",   "Gamma", "Delta", "Theta", "Lambda",
        "Xi",      "Pi",     "Sigma", "Upsilon", "Phi",     "Psi",   "Omega"};
    return std::find(letters.begin(), letters.end(), word) != letters.end();
}

std::string latex_word(const std::string& word) {
    if (word == "eps") return "\\varepsilon";
    if (is_greek(word)) return "\\" + word;
    if (!word.empty() && word.front() == '(') return "(" + latex_word(word.substr(1, word.size() - 2)) + ")";
    const bool number =
        std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); });
    return word.size() <= 1 || number ? word : "\\mathrm{" + word + "}";
}

// "theta12_max" -> theta, 12, max
std::vector<std::string> words_of(const std::string& name) {
    std::vector<std::string> words(1);
    for (char c : name) {
        const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
        const bool after_letter =
            !words.back().empty() && std::isalpha(static_cast<unsigned char>(words.back().back())) != 0;
        if (c == '_' || (digit && after_letter)) words.emplace_back();
        if (c != '_') words.back() += c;
    }
    words.erase(std::remove(words.begin(), words.end(), std::string()), words.end());
    return words.empty() ? std::vector<std::string>{name} : words;
}

std::string dotted(const std::string& symbol, int primes) {
    switch (primes) {
    case 0: return symbol;
    case 1: return "\\dot{" + symbol + "}";
    case 2: return "\\ddot{" + symbol + "}";
    default: return symbol + "^{(" + std::to_string(primes) + ")}";
    }
}

std::string parenthesised(const std::string& text) { return "\\left(" + text + "\\right)"; }

// Re and Im have macros of their own.
std::string function_macro(const std::string& name) {
    const std::optional<Function> f = function_called(name);
    return f ? std::string(row_of(*f).latex) : "\\" + name;
}

// 3 \theta, psi: read without parentheses behind \cos.
bool is_simple_argument(const DisplaySum& argument) {
    if (argument.terms.size() != 1) return false;
    const DisplayTerm& term = argument.terms.front();
    return !cln::minusp(term.coefficient) && cln::denominator(term.coefficient) == 1 && !term.imaginary &&
           term.factors.size() == 1 && term.factors.front().kind == FactorKind::symbol &&
           term.factors.front().exponent == 1 && term.tail.empty();
}

std::string function(const DisplayFactor& factor) {
    const DisplaySum& argument = factor.arguments.front();
    const std::string text = latex(argument);
    if (factor.name == "conj") return "\\overline{" + text + "}";
    if (factor.name == "old") return "{" + text + "}_{\\mathrm{old}}";
    if (!is_elementary(factor)) {
        const int n = factor.primes;
        const std::string name = latex_name(factor.name, 0);
        const std::string primes =
            n <= 3 ? std::string(static_cast<std::size_t>(n), '\'') : "^{(" + std::to_string(n) + ")}";
        return name + primes + parenthesised(text);
    }
    return function_macro(factor.name) + " " + (is_simple_argument(argument) ? text : parenthesised(text));
}

bool has_macro(const DisplayFactor& function) { return is_elementary(function) && function.name != "conj"; }

std::string integral(const DisplayFactor& factor) {
    const DisplaySum& integrand = factor.arguments[0];
    const bool one_term = integrand.terms.size() == 1 && !is_bare_sum(integrand.terms.front());
    return fmt::format(
        "\\int\\limits_{{{}}}^{{{}}} {} \\, d{}", latex(factor.arguments[2]), latex(factor.arguments[3]),
        one_term ? latex(integrand) : parenthesised(latex(integrand)), latex(factor.arguments[1]));
}

std::string inner(const DisplayFactor& factor) {
    switch (factor.kind) {
    case FactorKind::symbol: return latex_name(factor.name, factor.primes);
    case FactorKind::number: return latex(number_sum(factor.number));
    case FactorKind::sum: return latex(factor.arguments.front());
    case FactorKind::function: return function(factor);
    case FactorKind::integral: return integral(factor);
    case FactorKind::power:
        return latex(factor.arguments[0].terms.front().factors.front()) + "^{" + latex(factor.arguments[1]) +
               "}";
    }
    return {};
}

std::string exponent_text(const Rational& exponent) { return "^{" + to_string(exponent) + "}"; }

std::string power(const DisplayFactor& factor, const Rational& exponent) {
    const std::string base = inner(factor);
    if (exponent == Rational(1) / 2) return "\\sqrt{" + base + "}";
    const bool atom = factor.kind == FactorKind::symbol || exponent == 1;
    const bool primed_symbol = factor.kind == FactorKind::symbol && factor.primes > 2 && exponent != 1;
    const bool bare = atom && factor.kind != FactorKind::sum && !primed_symbol;
    return (bare ? base : parenthesised(base)) + (exponent == 1 ? std::string() : exponent_text(exponent));
}

// Digits side by side would read as one number.
void append(std::string& text, const std::string& factor) {
    const bool digits = !text.empty() && std::isdigit(static_cast<unsigned char>(text.back())) != 0 &&
                        std::isdigit(static_cast<unsigned char>(factor.front())) != 0;
    if (!text.empty()) text += digits ? " \\cdot " : " ";
    text += factor;
}

// Factors side by side, as above a fraction bar or below; a lone sum needs no parentheses there.
struct LatexProduct {
    std::string text;
    std::string lone_sum = {}; // of the only factor so far, if that is a sum
    // Where the argument without parentheses begins that ends the text; 0: none does.
    std::size_t argument = 0;

    // \sin \theta \varepsilon would read as the sine of a product; \sin \theta \cos \theta does not.
    void multiply(const DisplayFactor& factor, const Rational& exponent) {
        const bool one = exponent == 1;
        lone_sum = text.empty() && factor.kind == FactorKind::sum && one ? inner(factor) : std::string();
        const bool function = factor.kind == FactorKind::function && has_macro(factor) && one;
        if (!function && argument > 0) text = text.substr(0, argument) + parenthesised(text.substr(argument));
        append(text, power(factor, exponent));
        const bool bare = function && is_simple_argument(factor.arguments.front());
        argument = bare ? text.size() - latex(factor.arguments.front()).size() : 0;
    }
    [[nodiscard]] const std::string& on_bar() const { return lone_sum.empty() ? text : lone_sum; }
};

// |coefficient| * [i] * factors; integrals and functions stand after the fraction bar.
LatexProduct head(const DisplayTerm& term) {
    const Rational size = cln::abs(term.coefficient);
    LatexProduct above, below, behind;
    if (term.digits > 0) {
        if (size != 1) above.text = decimal_latex(size, term.digits);
    } else if (cln::numerator(size) != 1) {
        above.text = to_string(Rational(cln::numerator(size)));
    }
    if (term.digits == 0 && cln::denominator(size) != 1)
        below.text = to_string(Rational(cln::denominator(size)));
    if (term.imaginary) append(above.text, "i");
    for (const DisplayFactor& factor : term.factors) {
        const bool wide = factor.kind == FactorKind::function || factor.kind == FactorKind::integral;
        LatexProduct& place = factor.exponent < 0 ? below : wide ? behind : above;
        place.multiply(factor, cln::abs(factor.exponent));
    }
    LatexProduct all{above.text};
    if (!below.text.empty())
        all.text =
            fmt::format("\\frac{{{}}}{{{}}}", above.text.empty() ? "1" : above.on_bar(), below.on_bar());
    if (!behind.text.empty()) append(all.text, behind.text);
    if (behind.argument > 0) all.argument = all.text.size() - behind.text.size() + behind.argument;
    return all;
}

std::string unsigned_term(const DisplayTerm& term) {
    if (is_bare_sum(term)) return latex(term.factors.front().arguments.front());
    LatexProduct product = head(term);
    for (const DisplayFactor& factor : term.tail) product.multiply(factor, factor.exponent);
    return product.text.empty() ? "1" : product.text;
}

} // namespace

std::string latex(const DisplaySum& sum) { return signed_sum(sum, unsigned_term); }

std::string latex(const DisplayFactor& factor) { return power(factor, factor.exponent); }

std::string latex_name(const std::string& name, int primes) {
    const std::vector<std::string> words = words_of(name);
    std::string text = dotted(latex_word(words.front()), primes);
    if (words.size() == 1) return text;
    std::string subscript;
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (i > 1) subscript += ",";
        subscript += latex_word(words[i]);
    }
    return text + "_{" + subscript + "}";
}

std::string with_bracketed_subscript(const std::string& name) {
    const std::vector<std::string> words = words_of(name);
    if (words.size() == 1) return words.front() + "_()"; // of x_ beside x
    std::string text = words.front();
    for (std::size_t i = 1; i < words.size(); ++i) text += "_(" + words[i] + ")";
    return text;
}

std::string latex_text(const std::string& text) {
    std::string escaped;
    for (char c : text) {
        if (c == '\\')
            escaped += "\\textbackslash{}";
        else if (c == '^' || c == '~')
            escaped += std::string("\\") + c + "{}";
        else if (std::string_view("#$%&_{}").find(c) != std::string_view::npos)
            escaped += std::string("\\") + c;
        else
            escaped += c;
    }
    return escaped;
}

} // namespace resonform
