// SPDX-License-Identifier: GPL-3.0-or-later
// The reader of user expressions: the paper's notation (psi'', x^2, sqrt(s), decimals exact) into
// GiNaC, with limits on length, depth, integer size and exponent. GiNaC's own parser never sees
// user text.
//
//   "(xi^2 + r^2)*psi'' + g*sin(psi) = 0"
#pragma once

#include "algebra/error.hpp"

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace resonform {

// Where a text comes from, so that a column in it can be shown in the file.
struct SourceText {
    std::string file;
    std::string key; // "equations.psi"
    int line = 0;
    int column = 0; // column of the first character of the text in its line
    std::string source_line;
};

// The symbols that a text may use. Primes count derivatives: ("psi", 2) is psi''.
class Scope {
public:
    void define(const std::string& name, const GiNaC::ex& value);
    // The k-th time derivative of a declared variable; k beyond what is defined is an error that
    // names the variable and the largest k.
    void define_derivative(const std::string& name, int primes, const GiNaC::ex& value);
    [[nodiscard]] const GiNaC::ex* find(const std::string& name, int primes) const;
    [[nodiscard]] std::vector<std::string> names() const; // for "nearest known"

private:
    std::map<std::pair<std::string, int>, GiNaC::ex> values_;
};

struct Limits {
    std::size_t length = 100000; // bytes
    int depth = 200;             // nested parentheses, functions and powers
    int digits = 1000;           // of one number, its decimal exponent included
    int exponent = 1000;         // |numerator|, |denominator| of a numeric exponent
};

// Functions: sin cos tan exp log sqrt sinh cosh tanh asin acos atan (and what FirstOrder expansion
// supports); operators + - * / ^ ** and parentheses; `pi`.
// Errors: bad_input with place, the offending text and the nearest known name.
GiNaC::ex read_expression(std::string_view text, const Scope& scope, const SourceText& source,
                          const Limits& limits = {});

// "lhs = rhs" -> lhs - rhs. Exactly one '='.
GiNaC::ex read_equation(std::string_view text, const Scope& scope, const SourceText& source,
                        const Limits& limits = {});

// The highest number of primes that follow each identifier in a text (a scan, before symbols exist).
std::map<std::string, int> highest_primes(std::string_view text, const SourceText& source);

// The known name nearest to `name` (edit distance at most 1 + length/3), or "".
std::string nearest(const std::string& name, const std::vector<std::string>& known);

} // namespace resonform
