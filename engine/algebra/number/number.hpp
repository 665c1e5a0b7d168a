// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers: CLN integers and rationals, and the few conversions the engine needs.
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>

#include <string>
#include <string_view>

namespace resonform {

using Integer = cln::cl_I;
using Rational = cln::cl_RA;

// Reads "12", "-3/4", "0.25", "1.5e-3" exactly: a decimal is the rational it spells.
// Throws Error(bad_input) on anything else, and on more than 4000 digits or |exponent| > 4000.
Rational parse_rational(std::string_view text);

std::string to_string(const Rational& value); // "-3/4", "5"
double to_double(const Rational& value);
Rational exact_rational(double value); // 0.5 -> 1/2; precondition: finite

Rational power_of_ten(int n); // n of any sign

// The largest number of which both are whole multiples: 4/3, -2 -> 2/3;  0, -2 -> 2.
Rational common_measure(const Rational& a, const Rational& b);

// The exact k-th root if there is one (k >= 1): exact_root(9/4, 2) = 3/2. Returns false otherwise.
bool exact_root(const Rational& value, int k, Rational& root);

} // namespace resonform
