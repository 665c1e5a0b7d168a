// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/slow_law.hpp"

#include "algebra/ring/constant.hpp"

namespace resonform {

namespace {

// Without the powers of eps.
Polynomial at_eps_one(const Ring& ring, const Polynomial& p) {
    std::vector<Term> terms;
    for (const Term& t : p.terms()) {
        std::vector<int> exponents = ring.exponents(t.monomial);
        for (GeneratorId id = 0; id < ring.size(); ++id)
            if (ring.generator(id).kind == GeneratorKind::small) exponents[static_cast<std::size_t>(id)] = 0;
        terms.push_back({ring.monomial(exponents), t.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

// The ring has inverses of divisors that are not proved to be nonzero.
bool has_divisor(const Ring& ring, const Polynomial& p) {
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.kind == GeneratorKind::root && !g.positive &&
            ring.exponent(p.terms().front().monomial, id) != 0)
            return true;
    }
    return false;
}

} // namespace

std::optional<SlowPath> slow_path(const Ring& ring, GeneratorId xi, const Polynomial& rate) {
    if (!ring.derivative_known(rate, xi)) return std::nullopt;
    // Not by its terms: the ring may write xi by a root that it has of it.
    SlowPath path{{}, -ring.derivative(rate, xi)};
    path.drive = rate + ring.multiply(path.decline, ring.gen(xi));
    const Polynomial b = at_eps_one(ring, path.decline);
    if (!is_constant(ring, b) || !is_constant(ring, at_eps_one(ring, path.drive))) return std::nullopt;
    // A sum of several powers of eps may vanish at one eps.
    const bool nonzero = path.decline.size() == 1 && ring.inverse(b) && !has_divisor(ring, b);
    if (path.relaxes() && !nonzero) return std::nullopt;
    return path;
}

} // namespace resonform
