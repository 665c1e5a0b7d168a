// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/decimal.hpp"

#include <cln/integer_io.h>

#include <fmt/format.h>

namespace resonform {

namespace {

struct Decimal {
    std::string digits; // the point stands after the first
    int exponent = 0;
};

// The largest n with 10^n <= value.
int exponent_of(const Rational& value) {
    constexpr double log10_of_2 = 0.30102999566398119521;
    const auto length = [](const Integer& n) { return static_cast<double>(cln::integer_length(n)); };
    int n = static_cast<int>((length(cln::numerator(value)) - length(cln::denominator(value))) * log10_of_2);
    while (power_of_ten(n) > value) --n;
    while (power_of_ten(n + 1) <= value) ++n;
    return n;
}

Decimal rounded(const Rational& value, int digits) {
    if (cln::zerop(value)) return {"0", 0};
    Decimal result{{}, exponent_of(value)};
    const Rational scaled = value * power_of_ten(digits - 1 - result.exponent);
    Integer n = cln::round1(scaled);
    if (Rational(n) >= power_of_ten(digits)) { // 9.99...
        n = cln::numerator(power_of_ten(digits - 1));
        ++result.exponent;
    }
    result.digits = to_string(Rational(n));
    if (scaled == Rational(n)) result.digits.erase(result.digits.find_last_not_of('0') + 1);
    return result;
}

bool is_plain(const Decimal& d, int digits) { return d.exponent >= -5 && d.exponent < digits; }

std::string plain(const Decimal& d) {
    if (d.exponent < 0) return "0." + std::string(static_cast<std::size_t>(-1 - d.exponent), '0') + d.digits;
    const auto before = static_cast<std::size_t>(d.exponent) + 1;
    if (d.digits.size() <= before) return d.digits + std::string(before - d.digits.size(), '0');
    return d.digits.substr(0, before) + "." + d.digits.substr(before);
}

std::string mantissa(const Decimal& d) { return plain({d.digits, 0}); }

} // namespace

std::string decimal(const Rational& value, int digits) {
    const Decimal d = rounded(value, digits);
    return is_plain(d, digits) ? plain(d) : fmt::format("{}e{}", mantissa(d), d.exponent);
}

std::string decimal_latex(const Rational& value, int digits) {
    const Decimal d = rounded(value, digits);
    return is_plain(d, digits) ? plain(d) : fmt::format("{}\\cdot 10^{{{}}}", mantissa(d), d.exponent);
}

} // namespace resonform
