// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of the parser and their messages; functions that have a value.
#include "algebra/number/error.hpp"
#include "algebra/number/functions.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/function_call.hpp"
#include "model/text/growth.hpp"
#include "model/text/named_function.hpp"
#include "model/text/nearest.hpp"
#include "model/text/parser.hpp"
#include "model/text/scope.hpp"
#include "model/text/why_unreal.hpp"
#include "model/text/zero_test.hpp"

#include <fmt/format.h>

#include <optional>

namespace resonform {

using GiNaC::numeric;

namespace {

constexpr int most_slopes = 9;

// sqrt(1 - x) at x = 2, which the library makes I, or at x = 7.
bool is_unreal(const GiNaC::ex& e) {
    for (auto it = e.preorder_begin(); it != e.preorder_end(); ++it)
        if (GiNaC::is_a<numeric>(*it) && !GiNaC::ex_to<numeric>(*it).is_real()) return true;
    return !why_unreal(e, {}).empty();
}

} // namespace

void Parser::expect_end(bool equation) {
    const Token& token = next();
    if (token.kind == TokenKind::end) return;
    if (token.kind == TokenKind::equals) {
        complain(token.begin, token.end,
                 equation ? "the equation does not have exactly one '='" : "an expression here has no '='",
                 equation ? "remove the second" : "give the value alone");
    }
    if (token.kind == TokenKind::comma) {
        complain(token.begin, token.end, "an expression holds a comma",
                 "write decimals with a point; functions take one argument");
    }
    complain(token.begin, token.end, "a ')' closes nothing", "remove it or add the '('");
}

// omega''(2*tau) where omega has a value: as if it stood here.
Parser::Piece Parser::value_at(const Token& call, const FunctionValue& function, const Piece& argument) {
    if (call.primes > most_slopes)
        complain(call.begin, call.end,
                 "a function that has a value is differentiated at most " + std::to_string(most_slopes) +
                     " times",
                 "write fewer primes");
    Piece piece = argument;
    piece.begin = call.begin;
    FunctionValue slope = function;
    for (int k = 0; k < call.primes; ++k) {
        slope = slope.slope();
        check_growth(of_expression(slope.value), piece.begin, piece.end);
    }
    piece.growth = of_substitution(slope.value, slope.argument, argument.growth);
    check_growth(piece.growth, piece.begin, piece.end);
    piece.value = evaluate(piece.begin, piece.end, [&] { return slope.at(argument.value); });
    if (is_unreal(piece.value))
        complain(piece.begin, piece.end, "the value of a function is real",
                 "correct the argument, or the expression that gives the function");
    return piece;
}

// At a number it is one, exactly.
GiNaC::ex Parser::data_at(const Token& call, const Scope::Data& data, const Piece& argument) {
    const PiecewisePolynomial& samples = *data.samples;
    const bool number =
        GiNaC::is_a<numeric>(argument.value) && argument.value.info(GiNaC::info_flags::rational);
    if (!number) {
        const bool its_own = GiNaC::is_a<GiNaC::symbol>(argument.value) &&
                             GiNaC::ex_to<GiNaC::symbol>(argument.value).get_name() == data.of;
        if (its_own) return named_function(samples.name, call.primes, argument.value);
        complain(argument.begin, argument.end, "a function that is given by data stands at its slow variable",
                 "write " + samples.name + "(" + data.of + "), or a rational number in its place",
                 Reason::by_kind);
    }
    const Rational at = cln::the<cln::cl_RA>(GiNaC::ex_to<numeric>(argument.value).to_cl_N());
    if (!samples.holds(at))
        complain(argument.begin, argument.end,
                 fmt::format("the data of {} reach from {} to {}", samples.name, samples.breakpoints.front(),
                             samples.breakpoints.back()),
                 "give more data, or another value", Reason::by_kind);
    return numeric(cln::cl_N(samples.at(at, call.primes)));
}

numeric Parser::checked_exponent(const Piece& exponent) {
    numeric n = GiNaC::ex_to<numeric>(exponent.value);
    const numeric limit(limits_.exponent);
    if (GiNaC::abs(n.numer()) > limit || n.denom() > limit) {
        complain(exponent.begin, exponent.end,
                 "an exponent is a fraction of integers of at most " + std::to_string(limits_.exponent),
                 "use a smaller exponent");
    }
    return n;
}

void Parser::check_argument(const std::string& function, const Piece& argument) {
    if (function == "log" && vanishes(argument.value) == Zero::yes) {
        complain(argument.begin, argument.end, "log has no value at zero", "correct the argument");
    }
    if (!GiNaC::is_a<numeric>(argument.value)) return;
    const std::optional<Function> known = function_called(function);
    const GiNaC::ex asked = known ? asked_of(argument.value, *known) : argument.value;
    const bool real = (!known && function != "sqrt") || !asked.info(GiNaC::info_flags::negative);
    if (!real) {
        complain(argument.begin, argument.end, function + " of this number is not real",
                 "write the real value meant");
    }
}

void Parser::check_growth(const Growth& growth, std::size_t begin, std::size_t end) {
    // Negated comparisons, so that a bound that overflowed to NaN is refused too.
    if (!(growth.bits <= limits_.bits)) {
        complain(begin, end,
                 "the numbers of an expression stay below 2^" +
                     std::to_string(static_cast<long>(limits_.bits)) + " when it is expanded",
                 "use smaller numbers or exponents");
    }
    if (!(growth.terms <= limits_.terms)) {
        complain(begin, end,
                 "an expression has at most " + std::to_string(static_cast<long>(limits_.terms)) +
                     " terms when it is expanded",
                 "use smaller exponents or fewer products of sums");
    }
    if (!(growth.degree <= limits_.degree)) {
        complain(begin, end,
                 "an expression is at most of degree " + std::to_string(static_cast<long>(limits_.degree)),
                 "use smaller exponents");
    }
}

std::string Parser::spelling(const Token& token) const { return excerpt(text_, token.begin, token.end); }

void Parser::complain(std::size_t begin, std::size_t end, std::string rule, std::string hint,
                      Reason reason) const {
    bad_input(reason, {std::move(rule), excerpt(text_, begin, end), std::move(hint),
                       place_at(source_, text_, begin)});
}

void Parser::missing_operand() const {
    const Token& token = next();
    if (tokens_.size() == 1)
        bad_input(Reason::syntax, {"the expression is empty", "\"" + excerpt(text_) + "\"", "write one",
                                   place_at(source_, text_, 0)});
    if (token.kind == TokenKind::comma) {
        complain(token.begin, token.end, "an expression holds a comma",
                 "write decimals with a point; functions take one argument");
    }
    if (at_ == 0) {
        complain(token.begin, token.end, "an expression begins with none of number, name, sign and '('",
                 "write what stands before '" + spelling(token) + "'");
    }
    const Token& before = tokens_[at_ - 1];
    complain(before.begin, token.end, "something stands after '" + spelling(before) + "'",
             "write the missing number, name or '('");
}

void Parser::implicit_product() const {
    const Token& left = tokens_[at_ - 1];
    const Token& right = next();
    complain(left.begin, right.end, "a product is written without '*'",
             "write " + spelling(left) + "*" + spelling(right));
}

void Parser::unknown_name(const Token& token) const {
    const std::string name(text_.substr(token.begin, token.name_end - token.begin));
    if (scope_.find(name, 0) != nullptr) {
        int highest = 0;
        while (scope_.find(name, highest + 1) != nullptr) ++highest;
        if (highest == 0) {
            complain(token.begin, token.end, in_quotes(name) + " has no derivative here", "remove the primes",
                     Reason::name);
        }
        complain(token.begin, token.end,
                 in_quotes(name) + " is known here with at most " + std::to_string(highest) + " primes",
                 "write fewer", Reason::name);
    }
    if (tokens_[at_ + 1].kind == TokenKind::open) {
        complain(token.begin, token.end, "unknown function",
                 name == "ln" ? "write log, the natural logarithm" : suggest(name, function_names()),
                 Reason::name);
    }
    if (name == "t" && (scope_.has_derivatives() || source_.key == "hamiltonian.energy")) {
        complain(
            token.begin, token.end, "time has no name of its own in equations",
            "declare an angle phi with phi' = 1 and write phi for t; for eps*t, a slow variable tau with "
            "tau' = eps",
            Reason::name);
    }
    if (const Scope::Withheld* withheld = scope_.withheld(name))
        complain(token.begin, token.end, withheld->rule, withheld->hint, Reason::name);
    if (name == "E" || name == "e") {
        complain(token.begin, token.end, "unknown symbol", "write exp(1)", Reason::name);
    }
    complain(token.begin, token.end, "unknown symbol", suggest(name, scope_.names()), Reason::name);
}

void Parser::enter(std::size_t at) {
    if (++depth_ > limits_.depth) {
        complain(at, at + 1,
                 "parentheses, functions and powers nest at most " + std::to_string(limits_.depth) + " deep",
                 "flatten the expression");
    }
}

} // namespace resonform
