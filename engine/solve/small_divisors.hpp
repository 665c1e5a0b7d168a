// SPDX-License-Identifier: GPL-3.0-or-later
// The small divisors of a normal form by what becomes of them: they move in slow time or stand, and may
// divide products only that decay.
#pragma once

#include "solve/solution.hpp"

#include <string>
#include <vector>

namespace resonform {

// A divisor D that moves, and dD/dt by the leading parts of the slow rates, in the normal form's ring; of
// divisors that differ by a factor the smallest.
struct MovingDivisor {
    Polynomial divisor, rate;
};
std::vector<MovingDivisor> moving_divisors(const Normalization& normalization);

// Those of monomials with modes that decay or grow: they matter at the start alone, for what decays is gone
// before the divisor moves far.
std::vector<MovingDivisor> moving_divisors_at_start(const Normalization& normalization);

// A constant divisor is as good as zero where the phase D t stays small on t <= 1/eps: then the monomial that
// was divided by it cancels against its start value, but only in exact arithmetic. It must satisfy
// |D|^2 > (10^-4 eps)^2, so that two divisions by D leave eight digits of the real type. Of divisors that
// differ by a factor, only the smallest.
struct StandingDivisor {
    Polynomial divisor, square, least; // D, |D|^2, (10^-4 eps)^2
};
std::vector<StandingDivisor> standing_divisors(const Normalization& normalization);

Rational least_divisor(); // 10^-4, in units of eps

// A moving divisor that stands in no rate, and in these outputs only beside modes that decay:
//
//   u' = -(1 + s) u,   y' = -2 y + u^2,   s' = -eps:     y = z_2 - z_1^2/(2 s) + ...
//
// What the equations divide by is none of them, nor is Re lambda of a mode that passes
// (solve/flow/passage.hpp).
struct FadingDivisor {
    GeneratorId generator; // whose powers 1/D is
    MovingDivisor moving;
    int power;                              // the highest one of 1/D
    std::vector<std::vector<int>> products; // e^{<product, chi>} multiplies it, with the decays of the flow
};

std::vector<FadingDivisor> fading_divisors(const Solution& solution, const std::vector<std::string>& outputs);
bool fades(const std::vector<FadingDivisor>& fading, GeneratorId generator);

} // namespace resonform
