// SPDX-License-Identifier: GPL-3.0-or-later
// Normal forms in numbers of D digits, for systems that are too large for symbols (System::digits).
//
//   field -> balls, with more and more bits until the digits of every coefficient are known -> rounded
#pragma once

#include "normalize/recursion/poincare.hpp"

namespace resonform {

// Digits that are kept besides those that are asked for, so that a result can be certified to all of these.
constexpr int spare_digits = 20;

constexpr double bits_of_digit = 3.3219280948873623; // log(10)/log(2)

// The range of D.
constexpr int fewest_digits = 4, most_digits = 1000;

// The Poincare normal form and its map, each coefficient rounded to D + spare_digits significant digits, all
// of them certain. A coefficient whose ball still contains zero when all others are known, and which is then
// smaller than the largest of its series by that many digits, is left out. The field of the result is one in
// which modes and frequencies are rounded numbers in the same way. A divisor is zero only where that is
// exact, by the eigenvalues' closed forms or the symmetries of the spectrum (expand/modes/numeric_modes.hpp).
// Errors (refused): another style than poincare, a divisor that cannot be told from zero (ambiguous).
Normalization normalize_in_numbers(const std::shared_ptr<const GradedField>& field, int through,
                                   const NormalizeOptions& options = {});

// The second route over numbers: `n` is substituted into the original equations at random complex points, in
// balls. The residual of each equation and weight is smaller than 10^-(D + spare_digits/2) times the sum of
// the magnitudes of its terms; and the scan of certify/scan.hpp, with the divisors of `field`, which is
// that of normalize_in_numbers. There is no probability of an error: a residual is small, not zero.
Certificate certify_numbers(const Normalization& n, const std::shared_ptr<const GradedField>& field,
                            std::uint64_t seed = 1);

} // namespace resonform
