// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/ring_copy.hpp"

#include <stdexcept>
#include <utility>

namespace resonform {

RingCopy::RingCopy(const Ring& from, RingBuilder& to)
    : from_(from), to_(to), images_(static_cast<std::size_t>(from.size())) {
    images_[Ring::imaginary_unit].id = Ring::imaginary_unit;
}

GeneratorId RingCopy::add(Generator g, GeneratorId id, int factor) {
    g.radicand = (*this)(g.radicand);
    images_[static_cast<std::size_t>(id)] = {to_.next(), factor}; // an exponential's derivative contains it
    if (g.kind == GeneratorKind::root || g.kind == GeneratorKind::function)
        g.derivatives.clear(); // follow from the radicand, or the argument and the slope
    for (auto& [variable, derivative] : g.derivatives) {
        variable = images_[static_cast<std::size_t>(variable)].id;
        derivative = (*this)(derivative);
    }
    g.of.argument = (*this)(g.of.argument);
    if (g.of.sine >= 0) g.of.sine = images_[static_cast<std::size_t>(g.of.sine)].id;
    g.of.slope.reset(); // may hold later generators
    if (g.conjugate >= 0) g.conjugate = images_[static_cast<std::size_t>(g.conjugate)].id;
    return to_.add(std::move(g));
}

GeneratorId RingCopy::copy(GeneratorId id) { return add(from_.generator(id), id, 1); }

GeneratorId RingCopy::copy_refined(GeneratorId root, int factor, const std::string& name) {
    Generator g = from_.generator(root);
    g.index *= factor;
    g.name = name;
    return add(std::move(g), root, factor);
}

void RingCopy::copy_all() {
    for (GeneratorId id = Ring::imaginary_unit + 1; id < from_.size(); ++id) copy(id);
    copy_slopes();
}

void RingCopy::copy_slopes() {
    for (GeneratorId id = 0; id < from_.size(); ++id)
        if (const auto& slope = from_.generator(id).of.slope;
            slope && images_[static_cast<std::size_t>(id)].id >= 0)
            to_.set_slope(images_[static_cast<std::size_t>(id)].id, from_, *slope);
}

Polynomial RingCopy::operator()(const Polynomial& p) const {
    std::vector<Term> terms;
    for (const Term& t : p.terms()) {
        Monomial m;
        for (GeneratorId id = 0; id < from_.size(); ++id) {
            const int e = from_.exponent(t.monomial, id);
            if (e == 0) continue;
            const Image& image = images_[static_cast<std::size_t>(id)];
            if (image.id < 0)
                throw std::logic_error("generator " + from_.generator(id).name +
                                       " is used before it is copied");
            m = m + to_.gen(image.id, image.factor * e).terms().front().monomial;
        }
        terms.push_back({m, t.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

std::string fresh_name(const RingBuilder& builder, std::string wanted) {
    while (builder.id(wanted) >= 0) wanted += '_';
    return wanted;
}

} // namespace resonform
