// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/parser.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/functions.hpp"
#include "algebra/number/number.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/function_call.hpp"
#include "model/text/named_function.hpp"
#include "model/text/zero_test.hpp"

#include <cln/exception.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

bool is_function(const std::string& name) {
    const std::vector<std::string>& known = function_names();
    return std::find(known.begin(), known.end(), name) != known.end();
}

ex apply(const std::string& function, const ex& x) {
    const std::optional<Function> known = function_called(function);
    return known ? call(*known, x) : ex(GiNaC::sqrt(x));
}

bool begins_operand(TokenKind kind) {
    return kind == TokenKind::number || kind == TokenKind::name || kind == TokenKind::open;
}

// Digits of the mantissa plus the size of the decimal exponent of a number token.
std::size_t digits_of(std::string_view number) {
    constexpr std::size_t absurd = 1000000000;
    const std::size_t e = number.find_first_of("eE");
    std::size_t digits = std::min(e, number.size());
    if (e == std::string_view::npos) return digits;
    std::size_t exponent = 0;
    for (char c : number.substr(e + 1)) {
        if (c < '0' || c > '9') continue;
        exponent = std::min(absurd, 10 * exponent + static_cast<std::size_t>(c - '0'));
    }
    return digits + exponent;
}

} // namespace

Parser::Parser(std::string_view text, const Scope& scope, const SourceText& source, const Limits& limits)
    : text_(text), scope_(scope), source_(source), limits_(limits) {
    if (text.size() > limits.length) {
        bad_input(Reason::syntax, {"an expression has at most " + std::to_string(limits.length) + " bytes",
                                   std::to_string(text.size()) + " bytes", "shorten it or split the system",
                                   place_of(source)});
    }
    tokens_ = tokenize(text, source);
}

ex Parser::expression() {
    const Piece whole = sum();
    expect_end(false);
    return whole.value;
}

ex Parser::equation() {
    const Piece left = sum();
    if (next().kind == TokenKind::end) {
        complain(0, text_.size(), "the equation does not have exactly one '='", "write it as left = right");
    }
    if (!accept(TokenKind::equals)) expect_end(true);
    const Piece right = sum();
    expect_end(true);
    check_growth(of_sum(left.growth, right.growth), left.begin, right.end);
    return left.value - right.value;
}

// Addends are collected and added once: one by one would cost the square of their number.
Parser::Piece Parser::sum() {
    Piece total = product();
    GiNaC::exvector addends{total.value};
    while (next().kind == TokenKind::plus || next().kind == TokenKind::minus) {
        const bool minus = take().kind == TokenKind::minus;
        const Piece addend = product();
        total.growth = of_sum(total.growth, addend.growth);
        total.end = addend.end;
        check_growth(total.growth, total.begin, total.end);
        addends.push_back(minus ? ex(-addend.value) : addend.value);
    }
    if (addends.size() > 1) {
        total.value = evaluate(total.begin, total.end, [&] { return ex(GiNaC::add(addends)); });
    }
    return total;
}

Parser::Piece Parser::product() {
    Piece total = unary();
    GiNaC::exvector factors{total.value};
    while (next().kind == TokenKind::star || next().kind == TokenKind::slash) {
        const bool divide = take().kind == TokenKind::slash;
        Piece factor = unary();
        if (divide) factor = reciprocal(factor);
        total.growth = of_product(total.growth, factor.growth);
        total.end = factor.end;
        check_growth(total.growth, total.begin, total.end);
        factors.push_back(factor.value);
    }
    if (begins_operand(next().kind)) implicit_product();
    if (factors.size() > 1) {
        total.value = evaluate(total.begin, total.end, [&] { return ex(GiNaC::mul(factors)); });
    }
    return total;
}

// Signs are counted in a loop: a hundred thousand of them nest nothing.
Parser::Piece Parser::unary() {
    const std::size_t begin = next().begin;
    bool minus = false;
    while (next().kind == TokenKind::plus || next().kind == TokenKind::minus) {
        if (take().kind == TokenKind::minus) minus = !minus;
    }
    Piece piece = power();
    piece.begin = begin;
    if (minus) piece.value = -piece.value;
    return piece;
}

Parser::Piece Parser::power() {
    Piece base = primary();
    if (!accept(TokenKind::power)) return base;
    enter(next().begin);
    const Piece exponent = unary();
    --depth_;
    return raise(base, exponent);
}

Parser::Piece Parser::primary() {
    switch (next().kind) {
    case TokenKind::number: return number();
    case TokenKind::name: return name();
    case TokenKind::open: return parenthesis();
    default: missing_operand();
    }
}

Parser::Piece Parser::number() {
    const Token token = take();
    const std::string_view spelled = text_.substr(token.begin, token.end - token.begin);
    if (digits_of(spelled) > static_cast<std::size_t>(limits_.digits)) {
        complain(token.begin, token.end,
                 "a number has at most " + std::to_string(limits_.digits) +
                     " digits, its decimal exponent included",
                 "write a shorter number, or a parameter in its place");
    }
    Piece piece;
    const numeric value{cln::cl_N(parse_rational(spelled))};
    piece.value = value;
    piece.growth = growth_of_number(value);
    piece.begin = token.begin;
    piece.end = token.end;
    return piece;
}

Parser::Piece Parser::name() {
    const Token& token = next();
    const std::string name(text_.substr(token.begin, token.name_end - token.begin));
    if (scope_.is_function(name) || (is_function(name) && scope_.find(name, 0) == nullptr)) return call();
    Piece piece;
    piece.begin = token.begin;
    piece.end = token.end;
    if (const ex* value = scope_.find(name, token.primes)) {
        piece.value = *value;
        piece.growth.degree = 1;
    } else if (name == "pi" && token.primes == 0) {
        piece.value = GiNaC::Pi;
    } else {
        unknown_name(token);
    }
    take();
    if (next().kind == TokenKind::open) implicit_product();
    return piece;
}

Parser::Piece Parser::call() {
    const Token token = take();
    const std::string function(text_.substr(token.begin, token.name_end - token.begin));
    const bool named = scope_.is_function(function);
    if (token.primes > 0 && !named) {
        complain(token.begin, token.end, "primes follow a name that is not a variable",
                 "write the derivative of " + function + " in full");
    }
    if (next().kind != TokenKind::open) {
        complain(token.begin, token.end, "the argument of a function is not in parentheses",
                 "write " + function + "(...)");
    }
    const Piece argument = parenthesis();
    check_argument(function, argument);
    if (const FunctionValue* value = scope_.value_of(function)) return value_at(token, *value, argument);
    const Scope::Data* data = scope_.data_of(function);
    Piece piece = argument;
    piece.begin = token.begin;
    // The argument stays unexpanded inside the function, which is one factor from now on.
    if (function != "sqrt") piece.growth = {1, 1, argument.growth.bits, 0};
    piece.value = evaluate(piece.begin, piece.end, [&] {
        if (data != nullptr) return data_at(token, *data, argument);
        return named ? named_function(function, token.primes, argument.value)
                     : apply(function, argument.value);
    });
    return piece;
}

Parser::Piece Parser::parenthesis() {
    const Token open = take();
    if (next().kind == TokenKind::close) {
        complain(open.begin, next().end, "parentheses hold an expression", "write one or remove them");
    }
    enter(open.begin);
    Piece inner = sum();
    --depth_;
    if (next().kind == TokenKind::end || next().kind == TokenKind::equals) {
        complain(open.begin, open.end, "a '(' is not closed", "add the ')' or remove the '('");
    }
    if (next().kind == TokenKind::comma) expect_end(false);
    inner.begin = open.begin;
    inner.end = take().end;
    return inner;
}

Parser::Piece Parser::reciprocal(const Piece& denominator) {
    if (vanishes(denominator.value) == Zero::yes) {
        complain(denominator.begin, denominator.end, "a denominator is zero",
                 "this expression is zero for all values: correct it");
    }
    Piece piece = denominator;
    piece.value = evaluate(piece.begin, piece.end, [&] { return GiNaC::pow(denominator.value, -1); });
    return piece;
}

Parser::Piece Parser::raise(const Piece& base, const Piece& exponent) {
    if (!GiNaC::is_a<numeric>(exponent.value)) return raise_by_symbols(base, exponent);
    const numeric n = checked_exponent(exponent);
    Piece piece;
    piece.begin = base.begin;
    piece.end = exponent.end;
    piece.growth = of_power(base.growth, n.to_double());
    check_growth(piece.growth, piece.begin, piece.end);
    if (!n.is_positive() && vanishes(base.value) == Zero::yes) {
        complain(piece.begin, piece.end, "zero is raised to positive powers only",
                 "the base is zero for all values: correct it");
    }
    if (GiNaC::is_a<numeric>(base.value) && !n.is_integer() &&
        GiNaC::ex_to<numeric>(base.value).is_negative()) {
        complain(piece.begin, piece.end, "a fractional power of a negative number is not real",
                 "write the real value meant");
    }
    piece.value = evaluate(piece.begin, piece.end, [&] { return GiNaC::pow(base.value, n); });
    return piece;
}

// a^b = exp(b log a)
Parser::Piece Parser::raise_by_symbols(const Piece& base, const Piece& exponent) {
    check_argument("log", base);
    Piece piece = base;
    piece.end = exponent.end;
    piece.growth = {1, 1, std::max(base.growth.bits, exponent.growth.bits), 0}; // one factor, as a function
    piece.value =
        evaluate(piece.begin, piece.end, [&] { return GiNaC::exp(exponent.value * GiNaC::log(base.value)); });
    return piece;
}

ex Parser::evaluate(std::size_t begin, std::size_t end, const std::function<ex()>& build) {
    std::string failure;
    try {
        return build();
    } catch (const GiNaC::pole_error&) {
        complain(begin, end, "the expression has no value", "it is singular here: correct it");
    } catch (const std::domain_error& undefined) { // these three: model/text/regular.hpp
        failure = undefined.what();
    } catch (const std::overflow_error& division_by_zero) {
        failure = division_by_zero.what();
    } catch (const cln::runtime_exception& of_numbers) {
        failure = of_numbers.what();
    }
    complain(begin, end, "the expression has no value",
             "it cannot be evaluated (" + excerpt(failure) + "): correct it");
}

bool Parser::accept(TokenKind kind) {
    if (next().kind != kind) return false;
    take();
    return true;
}

} // namespace resonform
