// SPDX-License-Identifier: GPL-3.0-or-later
// Which monomials are resonant, as the certificate sees it.
#pragma once

#include "algebra/number/modular.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <vector>

namespace resonform {

// What the scan knows of one random point modulo a prime.
struct FrequencySample {
    PrimeField field;
    std::vector<Residue> growth, omega; // of each mode
    std::vector<Residue> angle;         // of each angle
    std::vector<Residue> generators;    // of the ring
};

// <alpha, lambda> - lambda_mode = growth + i frequency, of a monomial given by all its exponents.
class Resonance {
public:
    Resonance(const GradedField& field, const std::vector<FrequencySample>& samples)
        : field_(field), samples_(samples) {}

    // It is zero at all samples.
    [[nodiscard]] bool is_exact(const std::vector<int>& exponents, int mode) const;
    // The user's threshold, for divisors that are numbers; those that are zero may be among them.
    [[nodiscard]] bool is_near(const std::vector<int>& exponents, int mode) const;

private:
    struct Multiples {
        std::vector<int> growth, omega, angle;
    };
    [[nodiscard]] const Multiples& multiples_of(const std::vector<int>& exponents, int mode) const;

    const GradedField& field_;
    const std::vector<FrequencySample>& samples_;
    mutable Multiples multiples_; // asked for once for each monomial
};

} // namespace resonform
