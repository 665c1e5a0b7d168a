// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/real_ball.hpp"

#include "algebra/number/flint.hpp"

#include <cmath>

namespace resonform {

RealBall::RealBall(const Rational& number, std::int64_t bits) : RealBall() {
    Whole numerator(cln::numerator(number)), denominator(cln::denominator(number));
    arb_fmpz_div_fmpz(value_, numerator.get(), denominator.get(), bits);
}

Rational middle(const RealBall& ball) {
    Whole mantissa, exponent;
    arf_get_fmpz_2exp(mantissa.get(), exponent.get(), arb_midref(ball.get()));
    return mantissa.value() * cln::expt(Rational(2), exponent.value());
}

double nearest_double(const RealBall& ball) { return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR); }

// The rounding is done on integers, so that it is the same everywhere.
Rational rounded(const RealBall& ball, int digits) {
    const Rational value = middle(ball);
    if (cln::zerop(value)) return 0;
    // 10^scale <= |value| < 10^(scale + 1), but for the rounding of the logarithm: one digit more or less
    constexpr double log10_of_2 = 0.30102999566398119521;
    const double bits = static_cast<double>(cln::integer_length(cln::abs(cln::numerator(value)))) -
                        static_cast<double>(cln::integer_length(cln::denominator(value)));
    const int scale = static_cast<int>(std::floor(bits * log10_of_2));
    const int places = digits - 1 - scale;
    const Rational unit = power_of_ten(-places);
    return cln::round1(value / unit) * unit;
}

std::int64_t accurate_bits(const RealBall& ball) { return arb_rel_accuracy_bits(ball.get()); }

std::int64_t binary_exponent(const RealBall& ball) {
    mag_t bound;
    mag_init(bound);
    arb_get_mag(bound, ball.get());
    constexpr std::int64_t far_below = std::int64_t{-1} << 40;
    const std::int64_t exponent = mag_is_zero(bound) != 0 ? far_below : fmpz_get_si(MAG_EXPREF(bound));
    mag_clear(bound);
    return exponent;
}

} // namespace resonform
