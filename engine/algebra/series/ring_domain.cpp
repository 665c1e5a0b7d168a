// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/series/ring_domain.hpp"

namespace resonform {

// i e^{i theta} d/d(e^{i theta})
Polynomial RingDomain::angle_derivative(const Part& p, GeneratorId phase) const {
    return ring_->multiply(ring_->multiply(ring_->imaginary(), ring_->gen(phase)), derivative(p, phase));
}

Polynomial RingDomain::without_vanishing(const Part& p, const std::vector<GeneratorId>& outer) const {
    if (ring_->is_canonical()) return p;
    std::vector<Polynomial> rest;
    for (const auto& [monomial, coefficient] : ring_->collect(p, outer))
        if (!ring_->vanishes(coefficient))
            rest.push_back(ring_->multiply(Polynomial(monomial, 1), coefficient));
    return sum(rest);
}

} // namespace resonform
