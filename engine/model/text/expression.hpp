// SPDX-License-Identifier: GPL-3.0-or-later
// The reader of user expressions: the paper's notation (psi'', x^2, sqrt(s), decimals exact) into
// GiNaC, with limits on length, depth, integer size and exponent. GiNaC's own parser never sees
// user text.
//
//   "(xi^2 + r^2)*psi'' + g*sin(psi) = 0"
//
// Grammar (spaces are free; no implicit multiplication):
//   equation = sum "=" sum          product = unary { ("*" | "/") unary }
//   sum = product { ("+" | "-") product }     unary = { "+" | "-" } power
//   power = primary [ ("^" | "**") unary ]    so that -x^2 = -(x^2), 2^3^2 = 2^9, x^-2 is allowed
//   primary = number | name { "'" } | function "(" sum ")" | "(" sum ")"
#pragma once

#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace resonform {

// The symbols that a text may use. Primes count derivatives: ("psi", 2) is psi''.
class Scope {
public:
    void define(const std::string& name, const GiNaC::ex& value);
    // The k-th time derivative of a declared variable; k beyond what is defined is an error that
    // names the variable and the largest k.
    void define_derivative(const std::string& name, int primes, const GiNaC::ex& value);
    // A function that is known by its name only: omega(tau), omega'(tau).
    void define_function(const std::string& name) { functions_.push_back(name); }
    [[nodiscard]] bool is_function(const std::string& name) const;
    [[nodiscard]] const GiNaC::ex* find(const std::string& name, int primes) const;
    [[nodiscard]] std::vector<std::string> names() const; // for "nearest known"
    [[nodiscard]] bool has_derivatives() const;           // as equations have them

private:
    std::map<std::pair<std::string, int>, GiNaC::ex> values_;
    std::vector<std::string> functions_;
};

// What one expression may cost. All are checked before GiNaC evaluates anything.
struct Limits {
    std::size_t length = 100000; // bytes
    int depth = 200;             // nested parentheses, functions and powers
    int digits = 1000;           // of one number, its decimal exponent included
    int exponent = 1000;         // |numerator|, |denominator| of a numeric exponent
    double bits = 100000;        // of any number that the expression evaluates or expands to
    double terms = 100000;       // of the expression when it is expanded
    double degree = 10000;       // of the expression when it is expanded
};

// sin cos tan exp log sqrt sinh cosh tanh asin acos atan
const std::vector<std::string>& function_names();

// The value of the text over `scope`; `pi` is known everywhere. Numbers are exact: 0.1 is 1/10.
// a^b is exp(b log a) unless b is a number. Errors: bad_input with place, the offending text and the mend:
// a limit exceeded, a syntax error, an unknown name (with the nearest known), a division by an
// expression that is zero, a power or function of a number that is undefined or not real.
GiNaC::ex read_expression(std::string_view text, const Scope& scope, const SourceText& source,
                          const Limits& limits = {});

// "lhs = rhs" -> lhs - rhs. Exactly one '='.
GiNaC::ex read_equation(std::string_view text, const Scope& scope, const SourceText& source,
                        const Limits& limits = {});

// The highest number of primes that follow each identifier in a text (a scan, before symbols exist).
std::map<std::string, int> highest_primes(std::string_view text, const SourceText& source);

} // namespace resonform
