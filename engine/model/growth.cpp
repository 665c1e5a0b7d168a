// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

Growth of_sum(const Growth& a, const Growth& b) {
    return {a.terms + b.terms, std::max(a.degree, b.degree), a.bits + b.bits + 1};
}

Growth of_product(const Growth& a, const Growth& b) {
    return {a.terms * b.terms, a.degree + b.degree, a.bits + b.bits};
}

// A sum of t terms to the n-th power has at most binomial(t + n - 1, n) terms.
Growth of_power(const Growth& base, double exponent) {
    const double n = std::max(1.0, std::ceil(std::abs(exponent)));
    const double log_terms =
        std::lgamma(base.terms + n) - std::lgamma(n + 1) - std::lgamma(std::max(1.0, base.terms));
    Growth power;
    power.terms = base.terms <= 1 ? 1 : std::exp(log_terms);
    power.degree = base.degree * n;
    power.bits = (base.bits + std::log2(std::max(1.0, base.terms))) * n;
    return power;
}

} // namespace resonform
