// SPDX-License-Identifier: GPL-3.0-or-later
// Small divisors: what a monomial's homological equation divides by, and whether it may.
//
//   D(alpha) = <alpha, lambda> - lambda_j = i sum_m (alpha_m - alphabar_m) omega_m - i omega_j
#pragma once

#include "normalize/normal_form.hpp"

#include <map>
#include <vector>

namespace resonform {

struct Divisor {
    Polynomial value;
    DivisorVerdict verdict;
    Polynomial inverse; // only where the verdict is removed; empty: the ring does not hold it yet
};

// The divisors of one equation. This is the only place where the normaliser divides: a divisor has an
// inverse only if the ring proves that it is a unit.
class DivisorTable {
public:
    // mode: index of the mode whose equation it is, or -1 for a slow or drift variable (lambda = 0).
    DivisorTable(const GradedField& field, int mode);

    // The divisor of a monomial in modes and eps (other exponents zero). Looked up by its harmonics.
    // Errors (refused): proved neither to vanish nor not to vanish identically (ambiguous).
    const Divisor& of(const Monomial& monomial);
    // The frequencies k.omega of the divisors that were asked for and have no inverse in the ring.
    [[nodiscard]] const std::vector<Polynomial>& missing() const { return missing_; }

private:
    [[nodiscard]] Divisor make(const std::vector<int>& harmonics);

    const GradedField& field_;
    int mode_;
    std::map<std::vector<int>, Divisor> known_; // by alpha_m - alphabar_m
    std::vector<Polynomial> missing_;
};

} // namespace resonform
