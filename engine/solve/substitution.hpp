// SPDX-License-Identifier: GPL-3.0-or-later
// The oscillation put into series of the normal form's ring:
//   w = Delta e^{i theta},  wbar = Delta e^{-i theta},  Delta = eps C E(xi) (1 + eps B_1 + eps^2 B_2 + ...)
#pragma once

#include "solve/draft.hpp"

#include <vector>

namespace resonform {

// The normal form's rate of one variable, by powers of |w|^2 and eps. For the oscillator, w is divided
// out:  w'/w = sum a_kc |w|^(2k) eps^c;  for a drift  Z' = sum a_kc |w|^(2k) eps^c.
struct RateTerm {
    int k;
    int c;
    Polynomial coefficient; // a_kc in the normal form's ring
};

std::vector<RateTerm> oscillator_rate(const NormalForm& normal_form);
std::vector<RateTerm> drift_rate(const NormalForm& normal_form, std::size_t drift);

class Substitution {
public:
    // Takes envelope and factor of the draft as they stand; weights through `through` are kept.
    Substitution(const Draft& draft, int through);

    // Delta^m by powers of eps.
    [[nodiscard]] const Series& amplitude_power(int m) const;
    // [sum_kc a_kc eps^c Delta^(2k) extra]_weight for terms with real coefficients.
    [[nodiscard]] Polynomial rate_part(const std::vector<RateTerm>& terms, int weight) const;
    // The same times the factor 1 + eps B_1 + ...
    [[nodiscard]] Polynomial rate_part_times_factor(const std::vector<RateTerm>& terms, int weight) const;
    // p(w, wbar, eps; xi) by powers of eps.
    [[nodiscard]] Series operator()(const Polynomial& p) const;

private:
    const Draft& draft_;
    int through_;
    std::vector<Series> powers_;
    Series factor_;
};

} // namespace resonform
