// SPDX-License-Identifier: GPL-3.0-or-later
// Monomials, products, derivatives and the splittings of a Ring.
#include "algebra/ring/ring.hpp"

#include "algebra/number/error.hpp"
#include "algebra/ring/products.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>

namespace resonform {

std::optional<GeneratorId> Ring::find(const std::string& name) const {
    for (GeneratorId id = 0; id < size(); ++id) {
        if (generator(id).name == name) return id;
    }
    return std::nullopt;
}

Monomial Ring::monomial(const std::vector<int>& exponents) const { return packing_.pack(exponents); }

std::vector<int> Ring::exponents(const Monomial& m) const { return packing_.unpack(m, size()); }

int Ring::weight(const Monomial& m) const {
    int total = 0;
    for (GeneratorId id = 0; id < size(); ++id) {
        const int w = generator(id).weight;
        if (w != 0) total += w * exponent(m, id);
    }
    return total;
}

Polynomial Ring::gen(GeneratorId id, int exponent) const {
    const Generator& g = generator(id);
    if (exponent < 0 && !g.invertible) {
        refuse({.rule = "only what is known to be non-zero is divided by",
                .value = "division by " + g.name,
                .hint = "declare " + g.name + " positive, if it is",
                .place = {}});
    }
    return reduce(Polynomial(monomial(id, exponent), Rational(1)));
}

Polynomial Ring::reduce(Polynomial p) const {
    if (is_reduced(packing_, relations_, p.fractions())) return p;
    return Polynomial::from_fractions(rewrite(packing_, relations_, p.fractions()));
}

Polynomial Ring::multiply(const Polynomial& a, const Polynomial& b) const { return dot({{&a, &b}}); }

Polynomial Ring::dot(const std::vector<std::pair<const Polynomial*, const Polynomial*>>& pairs) const {
    std::vector<Product> products;
    products.reserve(pairs.size());
    for (const auto& [a, b] : pairs) products.push_back({1, a, b});
    return dot(products);
}

Polynomial Ring::dot(const std::vector<Product>& products) const {
    std::vector<FractionProduct> fractions;
    fractions.reserve(products.size());
    for (const Product& p : products)
        if (!p.left->empty() && !p.right->empty() && !cln::zerop(p.factor))
            fractions.push_back({&p.left->fractions(), &p.right->fractions(), p.factor});
    return collected(fractions);
}

Polynomial Ring::collected(const std::vector<FractionProduct>& products) const {
    require_safe(packing_, products);
    return Polynomial::from_fractions(rewrite(packing_, relations_, sum_of_products(products, &packing_)));
}

Polynomial Ring::power(const Polynomial& p, int exponent) const {
    if (exponent < 0) {
        const std::optional<Polynomial> reciprocal = inverse(p);
        if (!reciprocal) {
            refuse({.rule = "only a product of non-zero parameters, roots and their radicands is divided by",
                    .value = "a negative power of a sum",
                    .hint = "declare the parameters of the denominator positive, if they are",
                    .place = {}});
        }
        return power(*reciprocal, -exponent);
    }
    Polynomial result = one(), square = reduce(p);
    for (int n = exponent; n > 0; n /= 2) {
        if (n % 2 == 1) result = multiply(result, square);
        if (n > 1) square = multiply(square, square);
    }
    return result;
}

bool Ring::may_depend(GeneratorId generator_id, GeneratorId id) const {
    const Generator& g = generator(generator_id);
    if (g.kind == GeneratorKind::primitive && generator(id).kind == GeneratorKind::parameter) return true;
    if (std::find(g.unknown.begin(), g.unknown.end(), id) != g.unknown.end()) return true;
    return std::any_of(g.derivatives.begin(), g.derivatives.end(),
                       [&](const auto& entry) { return entry.first == id; });
}

// Precondition: may_depend.
const Polynomial* Ring::derivative_of(GeneratorId generator_id, GeneratorId id) const {
    const Generator& g = generator(generator_id);
    for (const auto& entry : g.derivatives) {
        if (entry.first == id) return &entry.second;
    }
    if (g.kind != GeneratorKind::primitive)
        refuse({.rule = "a derivative is taken where the ring holds it",
                .value = "d " + g.name + " / d " + generator(id).name,
                .hint = "ask for a lower order",
                .place = {}});
    refuse({.rule = "a primitive is differentiated with respect to slow variables only",
            .value = "d " + g.name + " / d " + generator(id).name,
            .hint = "list this derivative with the primitive",
            .place = {}});
}

Polynomial Ring::derivative(const Polynomial& p, GeneratorId id) const {
    const GeneratorKind kind = generator(id).kind;
    if (kind == GeneratorKind::imaginary || kind == GeneratorKind::root || kind == GeneratorKind::function ||
        kind == GeneratorKind::primitive) {
        refuse({.rule = "a derivative is taken with respect to an independent variable",
                .value = "d/d " + generator(id).name,
                .hint = "differentiate with respect to a variable or a parameter",
                .place = {}});
    }
    // sum over the generators v of p: (dp/dv) (dv/d id), dp/dv split by the exponents of v
    const Polynomial unit = one();
    std::deque<Fractions> partial; // a deque leaves them in their places
    std::vector<FractionProduct> products;
    for (GeneratorId v = 0; v < size(); ++v) {
        if (v != id && !may_depend(v, id)) continue;
        const std::map<int, Fractions> groups = by_exponent(p.fractions(), v);
        if (groups.empty()) continue;
        const Polynomial* inner = v == id ? &unit : derivative_of(v, id);
        for (const auto& [e, group] : groups) {
            partial.push_back(group);
            for (Monomial& m : partial.back().monomials) m = m - monomial(v);
            products.push_back({&partial.back(), &inner->fractions(), e});
        }
    }
    return collected(products);
}

// The terms that hold a generator, by its exponent.
std::map<int, Fractions> Ring::by_exponent(const Fractions& f, GeneratorId id) const {
    std::map<int, Fractions> groups;
    for (std::size_t k = 0; k < f.size(); ++k)
        if (const int e = exponent(f.monomials[k], id); e != 0) groups[e].append(f.monomials[k], f, k);
    return groups;
}

Polynomial Ring::conjugate(const Polynomial& p) const {
    Fractions f = p.fractions();
    for (GeneratorId id = 0; id < size(); ++id) {
        const Generator& g = generator(id);
        const bool swap = g.kind == GeneratorKind::fast && g.conjugate > id;
        if (!swap && g.kind != GeneratorKind::phase && g.kind != GeneratorKind::imaginary) continue;
        for (std::size_t k = 0; k < f.size(); ++k) {
            Monomial& m = f.monomials[k];
            const int e = exponent(m, id);
            if (swap) {
                const int shift = exponent(m, g.conjugate) - e;
                m = m + monomial(id, shift) - monomial(g.conjugate, shift);
            } else if (g.kind == GeneratorKind::phase) {
                m = m - monomial(id, 2 * e);
            } else if (e % 2 != 0) {
                f.negative[k] ^= 1;
            }
        }
    }
    return reduce(Polynomial::from_fractions(std::move(f)));
}

int Ring::weights_in_one() const {
    for (const Generator& g : generators_)
        if (g.kind == GeneratorKind::small && g.index > 0) return g.index;
    return 1;
}

std::vector<Polynomial> Ring::by_weight(const Polynomial& p, int through) const {
    std::vector<Fractions> parts(static_cast<std::size_t>(through + 1));
    const Polynomial reduced = reduce(p);
    const Fractions& f = reduced.fractions();
    for (std::size_t k = 0; k < f.size(); ++k) {
        const int w = weight(f.monomials[k]);
        if (w < 0) {
            refuse({.rule = "no term of a graded series has a negative weight",
                    .value = "a term of weight " + std::to_string(w),
                    .hint = "scale the variables so that eps does not stand in a denominator",
                    .place = {}});
        }
        if (w <= through) parts[static_cast<std::size_t>(w)].append(f.monomials[k], f, k);
    }
    std::vector<Polynomial> result;
    result.reserve(parts.size());
    for (Fractions& part : parts) result.push_back(Polynomial::from_fractions(std::move(part)));
    return result;
}

std::vector<std::pair<Monomial, Polynomial>> Ring::collect(const Polynomial& p,
                                                           const std::vector<GeneratorId>& outer) const {
    const Fractions& f = p.fractions();
    std::map<Monomial, Fractions> groups;
    for (std::size_t k = 0; k < f.size(); ++k) {
        const Monomial key = restricted(f.monomials[k], outer);
        groups[key].append(f.monomials[k] - key, f, k);
    }
    std::vector<std::pair<Monomial, Polynomial>> result;
    result.reserve(groups.size());
    for (auto& group : groups)
        result.emplace_back(group.first, Polynomial::from_fractions(std::move(group.second)));
    return result;
}

int Ring::lowest_exponent(const Polynomial& p, GeneratorId id) const {
    const std::vector<Monomial>& monomials = p.fractions().monomials;
    int lowest = exponent(monomials.front(), id);
    for (const Monomial& m : monomials) lowest = std::min(lowest, exponent(m, id));
    return lowest;
}

Monomial Ring::restricted(const Monomial& m, const std::vector<GeneratorId>& generators) const {
    Monomial key;
    for (GeneratorId id : generators) key = key + monomial(id, exponent(m, id));
    return key;
}

} // namespace resonform
