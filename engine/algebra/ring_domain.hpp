// SPDX-License-Identifier: GPL-3.0-or-later
// The canonical ring as a domain of coefficients. A domain is what the recursions over series are written
// for: a type of homogeneous parts, and the operations below on them (GraphDomain has them too).
#pragma once

#include "algebra/ring.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace resonform {

class RingDomain {
public:
    using Part = Polynomial;

    // The ring must outlive the domain.
    explicit RingDomain(const RingPtr& ring) : ring_(ring.get()) {}

    // A polynomial of the ring as an element of the domain.
    [[nodiscard]] Part constant(const Polynomial& p) const { return p; }
    [[nodiscard]] Part one() const { return ring_->one(); }
    [[nodiscard]] Part reduce(Part p) const { return ring_->reduce(std::move(p)); }
    [[nodiscard]] Part dot(const std::vector<Product>& products) const { return ring_->dot(products); }
    [[nodiscard]] Part combination(const std::vector<std::pair<Rational, const Part*>>& addends) const {
        return resonform::combination(addends);
    }
    // Of a part that depends on no outer variable, as the ring's operations of these names.
    [[nodiscard]] std::optional<Part> inverse(const Part& p) const { return ring_->inverse(p); }
    [[nodiscard]] std::optional<Part> rational_power(const Part& p, const Rational& exponent) const {
        return ring_->rational_power(p, exponent);
    }

private:
    const Ring* ring_;
};

} // namespace resonform
