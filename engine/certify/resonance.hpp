// SPDX-License-Identifier: GPL-3.0-or-later
// The resonant monomials, found independently of the normaliser.
#pragma once

#include "algebra/number/modular.hpp"
#include "certify/points/plan.hpp"
#include "certify/points/point.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <vector>

namespace resonform {

// The frequencies at one random point modulo a prime, for the scan.
struct FrequencySample {
    PrimeField field;
    std::vector<Residue> growth, omega; // of each mode
    std::vector<Residue> angle;         // of each angle
    std::vector<Residue> generators;    // of the ring
};
// At the n-th point of a run, which is `point`.
FrequencySample frequencies_of(const CertificatePlan& plan, const PointRun& run, std::size_t n,
                               const Point& point);

// <alpha, lambda> - lambda_mode = growth + i frequency, of a monomial given by all its exponents.
class Resonance {
public:
    Resonance(const GradedField& field, const std::vector<FrequencySample>& samples)
        : field_(field), samples_(samples) {}

    // Whether it is zero at all samples.
    [[nodiscard]] bool is_exact(const std::vector<int>& exponents, int mode) const;
    // Whether it is a number of at most the user's threshold [normal_form] near; zero may be included.
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
