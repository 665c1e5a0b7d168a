// SPDX-License-Identifier: GPL-3.0-or-later
// Ring::expanded_form: roots factored out, radicands written out again, for the printers.
#include "algebra/ring/cancellation.hpp"
#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/ring.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace resonform {
namespace {

struct Factored {
    Monomial factor;
    Polynomial numerator;
};

// Splits by the exponent of a root modulo its index; in each part the root is factored out.
std::vector<Factored> split(const Ring& ring, const std::vector<Factored>& parts, GeneratorId root) {
    const int k = ring.generator(root).index;
    std::vector<Factored> result;
    for (const Factored& part : parts) {
        const std::vector<Term>& terms = part.numerator.terms();
        if (std::all_of(terms.begin(), terms.end(),
                        [&](const Term& t) { return ring.exponent(t.monomial, root) == 0; })) {
            result.push_back(part);
            continue;
        }
        std::map<int, std::vector<Term>> classes;
        for (const Term& t : terms) {
            const int e = ring.exponent(t.monomial, root);
            classes[((e % k) + k) % k].push_back(t);
        }
        for (auto& group : classes) {
            const Polynomial p = Polynomial::from_terms(std::move(group.second));
            const Monomial lowest = ring.monomial(root, ring.lowest_exponent(p, root));
            result.push_back({part.factor + lowest, written_out(ring, divided(p, lowest), root)});
        }
    }
    return result;
}

} // namespace

Polynomial written_out(const Ring& ring, const Polynomial& p, GeneratorId root) {
    const Generator& g = ring.generator(root);
    std::map<int, std::vector<Term>> by_power;
    for (const Term& t : p.terms()) {
        const int n = std::max(0, ring.exponent(t.monomial, root) / g.index);
        by_power[n].push_back({t.monomial - ring.monomial(root, n * g.index), t.coefficient});
    }
    Polynomial total, power = ring.one();
    int n = 0;
    for (auto& group : by_power) {
        for (; n < group.first; ++n) power = plain_product(ring.packing(), power, g.radicand);
        const Polynomial part = Polynomial::from_terms(std::move(group.second));
        total = total + (n == 0 ? part : plain_product(ring.packing(), power, part));
    }
    return total;
}

std::vector<std::pair<Monomial, Polynomial>> Ring::expanded_form(const Polynomial& p) const {
    std::vector<Factored> parts{{Monomial{}, reduce(p)}};
    for (GeneratorId id = size() - 1; id >= 0; --id) {
        if (generator(id).kind == GeneratorKind::root) parts = split(*this, parts, id);
    }
    std::map<Monomial, Polynomial> sorted;
    for (const Factored& part : parts) {
        if (part.numerator.empty()) continue;
        Monomial common;
        for (GeneratorId id = 0; id < size(); ++id) {
            const Generator& g = generator(id);
            if (!g.invertible || g.kind == GeneratorKind::imaginary || g.kind == GeneratorKind::root)
                continue;
            common = common + monomial(id, lowest_exponent(part.numerator, id));
        }
        Polynomial& sum = sorted[part.factor + common];
        sum = sum + divided(part.numerator, common);
    }
    return {sorted.begin(), sorted.end()};
}

} // namespace resonform
