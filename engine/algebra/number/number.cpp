// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"

#include "algebra/number/error.hpp"

#include <cln/dfloat.h>
#include <cln/integer_io.h>
#include <cln/rational_io.h>
#include <cln/real.h>

#include <cstddef>
#include <cstdlib>
#include <sstream>

namespace resonform {
namespace {

constexpr std::size_t most_digits = 4000;
constexpr int largest_exponent = 4000;

[[noreturn]] void not_a_number(std::string_view text) {
    bad_input(
        {.rule = "not a number: it must be an integer, a fraction or a decimal, as 12, -3/4, 0.25, 1.5e-3",
         .value = std::string(text),
         .hint = "write the number in one of these forms",
         .place = {}});
}

[[noreturn]] void too_large(std::string_view text) {
    bad_input({.rule = "the number has more than 4000 digits, or a decimal exponent beyond -4000 ... 4000",
               .value = std::string(text),
               .hint = "scale the quantity by a unit of its own size",
               .place = {}});
}

// Reads a number from left to right; every reader leaves the rest in `rest_`.
class NumberReader {
public:
    explicit NumberReader(std::string_view text) : text_(text), rest_(text) {}

    Rational read() {
        const bool negative = sign();
        std::string digits = read_digits();
        std::size_t decimals = 0;
        Rational value;
        if (!digits.empty() && skip('/')) {
            value = quotient(digits, read_digits());
        } else {
            if (skip('.')) {
                const std::string fraction = read_digits();
                decimals = fraction.size();
                digits += fraction;
            }
            value = integer(digits) * power_of_ten(exponent() - static_cast<int>(decimals));
        }
        if (!rest_.empty()) not_a_number(text_);
        return negative ? -value : value;
    }

private:
    bool skip(char c) {
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }

    bool sign() {
        const bool negative = skip('-');
        if (!negative) skip('+');
        return negative;
    }

    std::string read_digits() {
        std::size_t n = 0;
        while (n < rest_.size() && rest_[n] >= '0' && rest_[n] <= '9') ++n;
        digits_ += n;
        if (digits_ > most_digits) too_large(text_);
        std::string digits(rest_.substr(0, n));
        rest_.remove_prefix(n);
        return digits;
    }

    int exponent() {
        if (!skip('e') && !skip('E')) return 0;
        const bool negative = sign();
        const std::string digits = read_digits();
        if (digits.empty()) not_a_number(text_);
        int value = 0;
        for (char c : digits) {
            value = 10 * value + (c - '0');
            if (value > largest_exponent) too_large(text_);
        }
        return negative ? -value : value;
    }

    Integer integer(const std::string& digits) const {
        if (digits.empty()) not_a_number(text_);
        return Integer(digits.c_str());
    }

    Rational quotient(const std::string& numerator, const std::string& denominator) const {
        const Integer below = integer(denominator);
        if (cln::zerop(below)) {
            bad_input({.rule = "the denominator of the fraction is zero",
                       .value = std::string(text_),
                       .hint = "give another denominator",
                       .place = {}});
        }
        return Rational(integer(numerator)) / below;
    }

    static Rational power_of_ten(int exponent) { return cln::expt(Rational(10), Integer(exponent)); }

    std::string_view text_;
    std::string_view rest_;
    std::size_t digits_ = 0;
};

} // namespace

Rational parse_rational(std::string_view text) { return NumberReader(text).read(); }

std::string to_string(const Rational& value) {
    const auto spelled = [](const Integer& n) {
        if (cln::integer_length(n) < 63) return std::to_string(cln::cl_I_to_long(n));
        std::ostringstream out; // a stream takes longer than the rest
        out << n;
        return out.str();
    };
    const std::string numerator = spelled(cln::numerator(value));
    const Integer denominator = cln::denominator(value);
    return denominator == 1 ? numerator : numerator + "/" + spelled(denominator);
}

Rational power_of_ten(int n) {
    if (n == 0) return 1; // expt_pos wants a positive exponent
    const Integer power = cln::expt_pos(Integer(10), static_cast<unsigned>(std::abs(n)));
    return n > 0 ? Rational(power) : 1 / Rational(power);
}

Rational common_measure(const Rational& a, const Rational& b) {
    return Rational(cln::gcd(cln::numerator(a), cln::numerator(b))) /
           cln::lcm(cln::denominator(a), cln::denominator(b));
}

double to_double(const Rational& value) { return cln::double_approx(value); }

Rational exact_rational(double value) { return cln::rational(cln::cl_DF(value)); }

bool exact_root(const Rational& value, int k, Rational& root) {
    if (k < 1) return false;
    if (cln::minusp(value)) {
        if (k % 2 == 0 || !exact_root(-value, k, root)) return false;
        root = -root;
        return true;
    }
    return cln::rootp(value, Integer(k), &root);
}

} // namespace resonform
