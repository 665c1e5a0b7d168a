// SPDX-License-Identifier: GPL-3.0-or-later
// The canonical ring as a domain of coefficients. The recursions over series are written for any domain: a
// type of homogeneous parts with the operations below (GraphDomain is another).
#pragma once

#include "algebra/ring/fractions.hpp"
#include "algebra/ring/ring.hpp"

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
    [[nodiscard]] bool is_zero(const Part& p) const { return ring_->vanishes(p); }
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

    [[nodiscard]] Part conjugate(const Part& p) const { return ring_->conjugate(p); }
    // d/d(id), and of a phase e^{i theta} by theta.
    [[nodiscard]] Part derivative(const Part& p, GeneratorId id) const { return ring_->derivative(p, id); }
    [[nodiscard]] Part angle_derivative(const Part& p, GeneratorId phase) const;
    // Drops coefficients over `outer` that vanish although they have terms, as in a ring that is not
    // canonical.
    [[nodiscard]] Part without_vanishing(const Part& p, const std::vector<GeneratorId>& outer) const;
    // The terms of p by the number that `share_of` gives the monomial of their outer generators.
    template <class ShareOf>
    [[nodiscard]] std::vector<Part> split(const Part& p, const std::vector<GeneratorId>& outer,
                                          ShareOf share_of) const;

private:
    const Ring* ring_;
};

template <class ShareOf>
std::vector<Polynomial> RingDomain::split(const Part& p, const std::vector<GeneratorId>& outer,
                                          ShareOf share_of) const {
    std::vector<Fractions> shares;
    Monomial last;
    std::size_t share = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const Monomial& m = p.fractions().monomials[k];
        const Monomial monomial = ring_->restricted(m, outer);
        if (k == 0 || monomial != last) share = share_of(monomial);
        last = monomial;
        if (share >= shares.size()) shares.resize(share + 1);
        shares[share].append(m, p.fractions(), k);
    }
    std::vector<Polynomial> parts;
    for (Fractions& f : shares) parts.push_back(Polynomial::from_fractions(std::move(f)));
    return parts;
}

} // namespace resonform
