// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/binary_parts.hpp"

#include <cstdlib>

namespace resonform {

BinaryParts binary_parts(const Rational& value, std::size_t count) {
    constexpr int plain = 480; // 2^-480 and seven times 53 bits are above the smallest double
    BinaryParts result;
    const int size = static_cast<int>(cln::integer_length(cln::numerator(value))) -
                     static_cast<int>(cln::integer_length(cln::denominator(value)));
    if (std::abs(size) > plain) result.exponent = size;
    Rational rest = value * cln::expt(Rational(2), -result.exponent);
    while (!cln::zerop(rest) && result.parts.size() < count) {
        result.parts.push_back(cln::double_approx(rest));
        rest = rest - exact_rational(result.parts.back());
    }
    return result;
}

} // namespace resonform
