// SPDX-License-Identifier: GPL-3.0-or-later
// Monomials, products, derivatives and the splittings of a Ring.
#include "algebra/ring.hpp"

#include "algebra/error.hpp"
#include "algebra/products.hpp"

#include <algorithm>
#include <cstddef>
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
                .mend = "declare " + g.name + " positive, if it is",
                .place = {}});
    }
    return reduce(Polynomial(monomial(id, exponent), Rational(1)));
}

Polynomial Ring::reduce(Polynomial p) const {
    return Polynomial::from_terms(rewrite(packing_, relations_, std::move(p).terms()));
}

Polynomial Ring::multiply(const Polynomial& a, const Polynomial& b) const { return dot({{&a, &b}}); }

Polynomial Ring::dot(const std::vector<std::pair<const Polynomial*, const Polynomial*>>& pairs) const {
    return Polynomial::from_terms(rewrite(packing_, relations_, collect_products(packing_, pairs)));
}

Polynomial Ring::power(const Polynomial& p, int exponent) const {
    if (exponent < 0) {
        const std::optional<Polynomial> reciprocal = inverse(p);
        if (!reciprocal) {
            refuse({.rule = "only a product of non-zero parameters, roots and their radicands is divided by",
                    .value = "a negative power of a sum",
                    .mend = "declare the parameters of the denominator positive, if they are",
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

const Polynomial* Ring::derivative_of(GeneratorId generator_id, GeneratorId id) const {
    const Generator& g = generator(generator_id);
    for (const auto& entry : g.derivatives) {
        if (entry.first == id) return &entry.second;
    }
    if (g.kind == GeneratorKind::primitive && generator(id).kind == GeneratorKind::parameter) {
        refuse({.rule = "a primitive is differentiated with respect to slow variables only",
                .value = "d " + g.name + " / d " + generator(id).name,
                .mend = "list this derivative with the primitive",
                .place = {}});
    }
    return nullptr;
}

Polynomial Ring::derivative(const Polynomial& p, GeneratorId id) const {
    const GeneratorKind kind = generator(id).kind;
    if (kind == GeneratorKind::imaginary || kind == GeneratorKind::root || kind == GeneratorKind::primitive) {
        refuse({.rule = "a derivative is taken with respect to an independent variable",
                .value = "d/d " + generator(id).name,
                .mend = "differentiate with respect to a variable or a parameter",
                .place = {}});
    }
    // sum over the generators v of p: (dp/dv) (dv/d id)
    std::vector<Polynomial> partial, inner;
    for (GeneratorId v = 0; v < size(); ++v) {
        std::vector<Term> terms;
        for (const Term& t : p.terms()) {
            const int e = exponent(t.monomial, v);
            if (e != 0) terms.push_back({t.monomial - monomial(v), Rational(e) * t.coefficient});
        }
        if (terms.empty()) continue;
        const Polynomial* dv = v == id ? nullptr : derivative_of(v, id);
        if (v != id && dv == nullptr) continue;
        partial.push_back(Polynomial::from_terms(std::move(terms)));
        inner.push_back(v == id ? one() : *dv);
    }
    std::vector<std::pair<const Polynomial*, const Polynomial*>> pairs;
    for (std::size_t k = 0; k < partial.size(); ++k) pairs.emplace_back(&partial[k], &inner[k]);
    return dot(pairs);
}

Polynomial Ring::conjugate(const Polynomial& p) const {
    std::vector<Term> terms = p.terms();
    for (GeneratorId id = 0; id < size(); ++id) {
        const Generator& g = generator(id);
        const bool swap = g.kind == GeneratorKind::fast && g.conjugate > id;
        if (!swap && g.kind != GeneratorKind::phase && g.kind != GeneratorKind::imaginary) continue;
        for (Term& t : terms) {
            const int e = exponent(t.monomial, id);
            if (swap) {
                const int shift = exponent(t.monomial, g.conjugate) - e;
                t.monomial = t.monomial + monomial(id, shift) - monomial(g.conjugate, shift);
            } else if (g.kind == GeneratorKind::phase) {
                t.monomial = t.monomial - monomial(id, 2 * e);
            } else if (e % 2 != 0) {
                t.coefficient = -t.coefficient;
            }
        }
    }
    return reduce(Polynomial::from_terms(std::move(terms)));
}

std::vector<Polynomial> Ring::by_weight(const Polynomial& p, int through) const {
    std::vector<std::vector<Term>> parts(static_cast<std::size_t>(through + 1));
    const Polynomial reduced = reduce(p);
    for (const Term& t : reduced.terms()) {
        const int w = weight(t.monomial);
        if (w < 0) {
            refuse({.rule = "no term of a graded series has a negative weight",
                    .value = "a term of weight " + std::to_string(w),
                    .mend = "scale the variables so that eps does not stand in a denominator",
                    .place = {}});
        }
        if (w <= through) parts[static_cast<std::size_t>(w)].push_back(t);
    }
    std::vector<Polynomial> result;
    result.reserve(parts.size());
    for (std::vector<Term>& terms : parts) result.push_back(Polynomial::from_terms(std::move(terms)));
    return result;
}

std::vector<std::pair<Monomial, Polynomial>> Ring::collect(const Polynomial& p,
                                                           const std::vector<GeneratorId>& outer) const {
    std::map<Monomial, std::vector<Term>> groups;
    for (const Term& t : p.terms()) {
        Monomial key;
        for (GeneratorId id : outer) key = key + monomial(id, exponent(t.monomial, id));
        groups[key].push_back({t.monomial - key, t.coefficient});
    }
    std::vector<std::pair<Monomial, Polynomial>> result;
    result.reserve(groups.size());
    for (auto& group : groups) {
        result.emplace_back(group.first, Polynomial::from_terms(std::move(group.second)));
    }
    return result;
}

} // namespace resonform
