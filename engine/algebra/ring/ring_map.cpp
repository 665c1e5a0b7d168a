// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/error.hpp"
#include "algebra/ring/ring.hpp"

#include <cstddef>
#include <map>
#include <utility>

namespace resonform {
namespace {

[[noreturn]] void refuse_map(const std::string& rule, const Generator& generator) {
    refuse({.rule = rule,
            .value = "the image of " + generator.name,
            .hint = "give an image that obeys the relations of " + generator.name,
            .place = {}});
}

} // namespace

RingMap::RingMap(RingPtr from, RingPtr to, std::vector<Polynomial> images)
    : from_(std::move(from)), to_(std::move(to)), images_(std::move(images)) {
    if (images_.size() != static_cast<std::size_t>(from_->size())) {
        refuse_map("every generator has an image", from_->generator(Ring::imaginary_unit));
    }
    for (GeneratorId id = 0; id < from_->size(); ++id) {
        const Generator& g = from_->generator(id);
        const Polynomial& image = images_[static_cast<std::size_t>(id)];
        Polynomial defect;
        if (g.kind == GeneratorKind::imaginary) defect = to_->power(image, 2) + to_->one();
        if (g.kind == GeneratorKind::root) defect = to_->power(image, g.index) - (*this)(g.radicand);
        if (!to_->vanishes(defect)) refuse_map("a map of rings keeps relations", g);
    }
}

RingMap RingMap::by_name(RingPtr from, RingPtr to, std::vector<std::pair<GeneratorId, Polynomial>> others) {
    std::vector<Polynomial> images(static_cast<std::size_t>(from->size()));
    std::vector<bool> given(images.size(), false);
    for (auto& other : others) {
        images[static_cast<std::size_t>(other.first)] = to->reduce(std::move(other.second));
        given[static_cast<std::size_t>(other.first)] = true;
    }
    for (std::size_t k = 0; k < images.size(); ++k) {
        if (given[k]) continue;
        const Generator& g = from->generator(static_cast<GeneratorId>(k));
        const std::optional<GeneratorId> same = to->find(g.name);
        if (!same) refuse_map("every generator has an image", g);
        images[k] = to->gen(*same);
    }
    return RingMap(std::move(from), std::move(to), std::move(images));
}

Polynomial RingMap::operator()(const Polynomial& p) const {
    // Images of one term are folded into the monomial; the others are multiplied, their powers kept.
    std::map<std::pair<GeneratorId, int>, Polynomial> powers;
    const auto power = [&](GeneratorId id, int e) -> const Polynomial& {
        const auto found = powers.find({id, e});
        if (found != powers.end()) return found->second;
        return powers[{id, e}] = to_->power(images_[static_cast<std::size_t>(id)], e);
    };
    std::vector<Term> simple;
    std::vector<Polynomial> products;
    for (const Term& t : p.terms()) {
        Term folded{Monomial{}, t.coefficient};
        std::vector<const Polynomial*> factors;
        for (GeneratorId id = 0; id < from_->size(); ++id) {
            const int e = from_->exponent(t.monomial, id);
            if (e == 0) continue;
            const Polynomial& factor = power(id, e);
            if (factor.size() == 1) {
                folded.monomial = folded.monomial + factor.terms().front().monomial;
                to_->packing().require_safe(folded.monomial);
                folded.coefficient = folded.coefficient * factor.terms().front().coefficient;
            } else {
                factors.push_back(&factor);
            }
        }
        if (factors.empty()) {
            simple.push_back(folded);
            continue;
        }
        Polynomial product(folded.monomial, folded.coefficient);
        for (const Polynomial* factor : factors) product = to_->multiply(product, *factor);
        products.push_back(std::move(product));
    }
    products.push_back(to_->reduce(Polynomial::from_terms(std::move(simple))));
    return sum(products);
}

} // namespace resonform
