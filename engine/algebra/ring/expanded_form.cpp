// SPDX-License-Identifier: GPL-3.0-or-later
// Ring::expanded_form: roots factored out, radicands written out again, for the printers.
#include "algebra/ring/cancellation.hpp"
#include "algebra/ring/fractions.hpp"
#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/products.hpp"
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
        const Fractions& f = part.numerator.fractions();
        if (std::all_of(f.monomials.begin(), f.monomials.end(),
                        [&](const Monomial& m) { return ring.exponent(m, root) == 0; })) {
            result.push_back(part);
            continue;
        }
        std::map<int, Fractions> classes;
        for (std::size_t n = 0; n < f.size(); ++n) {
            const int e = ring.exponent(f.monomials[n], root);
            classes[((e % k) + k) % k].append(f.monomials[n], f, n);
        }
        for (auto& group : classes) {
            const Polynomial p = Polynomial::from_fractions(std::move(group.second));
            const Monomial lowest = ring.monomial(root, ring.lowest_exponent(p, root));
            result.push_back({part.factor + lowest, written_out(ring, divided(p, lowest), root)});
        }
    }
    return result;
}

} // namespace

Polynomial written_out(const Ring& ring, const Polynomial& p, GeneratorId root) {
    const Generator& g = ring.generator(root);
    const Fractions& f = p.fractions();
    std::map<int, Fractions> by_power;
    for (std::size_t k = 0; k < f.size(); ++k) {
        const int n = std::max(0, ring.exponent(f.monomials[k], root) / g.index);
        by_power[n].append(f.monomials[k] - ring.monomial(root, n * g.index), f, k);
    }
    if (by_power.empty() || by_power.rbegin()->first == 0) return p;
    std::vector<Polynomial> powers{ring.one()};
    std::vector<FractionProduct> products;
    for (const auto& [n, group] : by_power) {
        while (static_cast<int>(powers.size()) <= n)
            powers.push_back(plain_product(ring.packing(), powers.back(), g.radicand));
        products.push_back({&powers[static_cast<std::size_t>(n)].fractions(), &group}); // of a shared body
    }
    require_safe(ring.packing(), products);
    return Polynomial::from_fractions(sum_of_products(products, &ring.packing()));
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
