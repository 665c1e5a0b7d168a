// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/as_written.hpp"

#include "algebra/number/number.hpp"
#include "model/text/canonical.hpp"
#include "model/text/expression.hpp"
#include "model/text/lexer.hpp"

#include <cln/rational.h>
#include <utility>
#include <vector>

namespace resonform {

namespace {

// The grammar of model/text/expression.hpp once more, over text that is known to obey it.
class Reader {
public:
    Reader(std::string text, const SourceText& source)
        : text_(std::move(text)), tokens_(tokenize(text_, source)) {}

    WrittenEquation equation() {
        WrittenEquation result;
        result.left = sum();
        take(); // =
        result.right = sum();
        return result;
    }

private:
    DisplaySum sum() {
        DisplaySum result;
        append(result, product(), false);
        while (at(TokenKind::plus) || at(TokenKind::minus)) {
            const bool negative = take().kind == TokenKind::minus;
            append(result, product(), negative);
        }
        return result;
    }

    DisplayTerm product() {
        DisplayTerm result;
        multiply(result, unary(), 1);
        while (at(TokenKind::star) || at(TokenKind::slash)) {
            const int exponent = take().kind == TokenKind::star ? 1 : -1;
            multiply(result, unary(), exponent);
        }
        return result;
    }

    DisplayTerm unary() {
        bool negative = false;
        while (at(TokenKind::plus) || at(TokenKind::minus))
            if (take().kind == TokenKind::minus) negative = !negative;
        DisplayTerm result = power();
        if (negative) result.coefficient = -result.coefficient;
        return result;
    }

    DisplayTerm power() {
        DisplayTerm base = primary();
        if (!at(TokenKind::power)) return base;
        take();
        return raised(base, constant());
    }

    // An exponent is a rational number, however it is written.
    Rational constant() {
        const std::size_t begin = next().begin;
        unary();
        const std::size_t end = next().begin;
        const GiNaC::ex value = read_expression(text_.substr(begin, end - begin), Scope{}, SourceText{});
        return to_rational(value);
    }

    DisplayTerm primary() {
        const Token token = take();
        DisplayTerm result;
        if (token.kind == TokenKind::number) {
            result.coefficient = parse_rational(text_.substr(token.begin, token.end - token.begin));
        } else if (token.kind == TokenKind::open) {
            result = as_term(sum());
            take(); // )
        } else if (at(TokenKind::open)) {
            const std::string function = text_.substr(token.begin, token.end - token.begin);
            take();
            DisplaySum argument = sum();
            take(); // )
            result = function == "sqrt" ? raised(as_term(std::move(argument)), Rational(1) / 2)
                                        : as_term(factor_sum(call(function, std::move(argument))));
        } else {
            result.factors.push_back(symbol_factor(text_.substr(token.begin, token.end - token.begin)));
        }
        return result;
    }

    // omega'(tau): the primes of a function that is known by its name.
    static DisplayFactor call(const std::string& function, DisplaySum argument) {
        const DisplayFactor name = symbol_factor(function);
        DisplayFactor factor = function_factor(name.name, std::move(argument));
        factor.primes = name.primes;
        return factor;
    }

    // A parenthesis around one term is none.
    static DisplayTerm as_term(DisplaySum sum) {
        if (sum.terms.size() == 1) return std::move(sum.terms.front());
        DisplayTerm term;
        term.factors.push_back(sum_factor(std::move(sum)));
        return term;
    }

    static DisplayTerm raised(const DisplayTerm& base, const Rational& exponent) {
        DisplayTerm term;
        const bool one_factor = base.coefficient == 1 && base.factors.size() == 1;
        // sqrt(x^2) is not x.
        if (one_factor && (base.factors.front().exponent == 1 || cln::denominator(exponent) == 1)) {
            term = base;
            term.factors.front().exponent = base.factors.front().exponent * exponent;
            return term;
        }
        term.factors.push_back(sum_factor(term_sum(base), exponent));
        return term;
    }

    static void multiply(DisplayTerm& product, const DisplayTerm& term, int exponent) {
        product.coefficient = product.coefficient * cln::expt(term.coefficient, exponent);
        for (DisplayFactor factor : term.factors) {
            factor.exponent = factor.exponent * exponent;
            product.factors.push_back(std::move(factor));
        }
    }

    static void append(DisplaySum& sum, DisplayTerm term, bool negative) {
        if (negative) term.coefficient = -term.coefficient;
        if (!cln::zerop(term.coefficient)) sum.terms.push_back(std::move(term));
    }

    [[nodiscard]] const Token& next() const { return tokens_[at_]; }
    [[nodiscard]] bool at(TokenKind kind) const { return next().kind == kind; }
    Token take() { return tokens_[at_++]; }

    std::string text_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
};

} // namespace

std::string with_values(const std::string& text, const SourceText& source,
                        const std::vector<Setting>& settings) {
    std::string result;
    std::size_t copied = 0;
    for (const Token& token : tokenize(text, source)) {
        if (token.kind != TokenKind::name) continue;
        const std::string name = text.substr(token.begin, token.end - token.begin);
        for (const Setting& setting : settings) {
            if (setting.parameter != name) continue;
            result += text.substr(copied, token.begin - copied) + "(" + setting.value + ")";
            copied = token.end;
        }
    }
    return result + text.substr(copied);
}

WrittenEquation as_written(const Equation& equation, const std::vector<Setting>& settings) {
    return Reader(with_values(equation.text, equation.source, settings), equation.source).equation();
}

} // namespace resonform
