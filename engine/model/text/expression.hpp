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
#include "model/text/scope.hpp"

#include <map>
#include <string>
#include <string_view>

namespace resonform {

// The value of the text over `scope`; `pi` is known everywhere. Numbers are exact: 0.1 is 1/10.
// a^b is exp(b log a) unless b is a number. Errors: bad_input with place, the offending text and the hint:
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
