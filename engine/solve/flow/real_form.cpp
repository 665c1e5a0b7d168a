// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/real_form.hpp"

#include "algebra/ring/ring_copy.hpp"

#include <cstdlib>
#include <utility>

namespace resonform {

namespace {

RealForm::Pair add_pair(RingBuilder& builder, const std::string& variable, bool real) {
    const auto add = [&](const char* part) {
        Generator g;
        g.kind = GeneratorKind::constant;
        g.name = fresh_name(builder, part + ("_" + variable));
        return builder.add(std::move(g));
    };
    const GeneratorId u = add("u");
    return {u, real ? GeneratorId(-1) : add("v")};
}

RealForm::Value split(const Ring& ring, const Polynomial& p) {
    std::vector<Term> re, im;
    for (const Term& t : p.terms()) {
        const int i = ring.exponent(t.monomial, Ring::imaginary_unit);
        (i == 0 ? re : im).push_back({t.monomial - ring.monomial(Ring::imaginary_unit, i), t.coefficient});
    }
    return {Polynomial::from_terms(std::move(re)), Polynomial::from_terms(std::move(im))};
}

} // namespace

RealForm::RealForm(const GradedField& field) : field_(field) {
    const Ring& old = *field.ring;
    RingBuilder builder;
    RingCopy copy(old, builder);
    std::vector<std::pair<GeneratorId, Polynomial>> gone;
    for (GeneratorId id = Ring::imaginary_unit + 1; id < old.size(); ++id) {
        const GeneratorKind kind = old.generator(id).kind;
        if (kind == GeneratorKind::fast || kind == GeneratorKind::phase)
            gone.emplace_back(id, Polynomial(Rational(1))); // lift_ never meets it
        else
            copy.copy(id);
    }
    copy.copy_slopes();
    const auto name = [&](std::size_t variable) { return field.system().variables[variable].name; };
    for (const Mode& mode : field.modes)
        modes_.push_back(add_pair(builder, name(mode.variable), mode.is_real()));
    for (const AngleVariable& angle : field.angles)
        angles_.push_back(add_pair(builder, name(angle.variable), false));
    ring_ = builder.freeze();
    lift_ = RingMap::by_name(field.ring, ring_, std::move(gone));

    eps_ = *ring_->find(old.generator(field.eps).name);
    for (const SlowVariable& slow : field.slow)
        slow_.push_back(*ring_->find(old.generator(slow.generator).name));
    const auto add_unit = [&](GeneratorId id, const Pair& pair, bool conjugate) {
        const Polynomial v =
            pair.is_real() ? Polynomial() : ring_->multiply(ring_->imaginary(), ring_->gen(pair.v));
        const Polynomial unit = conjugate ? ring_->gen(pair.u) - v : ring_->gen(pair.u) + v;
        outer_.push_back(id);
        units_.push_back(ring_->multiply(ring_->gen(eps_, old.generator(id).weight), unit));
    };
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        add_unit(field.modes[k].z, modes_[k], false);
        if (!field.modes[k].is_real()) add_unit(field.modes[k].zbar, modes_[k], true);
    }
    // Positive and negative powers of a phase: two units each after those of the modes.
    for (std::size_t k = 0; k < angles_.size(); ++k) {
        add_unit(field.angles[k].phase, angles_[k], false);
        add_unit(field.angles[k].phase, angles_[k], true);
    }
    powers_.assign(units_.size(), {ring_->one()});
}

const Polynomial& RealForm::power(std::size_t unit, int exponent) const {
    std::vector<Polynomial>& known = powers_[unit];
    while (static_cast<int>(known.size()) <= exponent)
        known.push_back(ring_->multiply(known.back(), units_[unit]));
    return known[static_cast<std::size_t>(exponent)];
}

std::vector<GeneratorId> RealForm::turning() const {
    std::vector<GeneratorId> outer = field_.outer();
    outer.pop_back(); // eps stays
    return outer;
}

RealForm::Value RealForm::operator()(const Polynomial& p) const {
    const Ring& old = *field_.ring;
    std::vector<Polynomial> parts;
    for (const auto& [monomial, coefficient] : old.collect(p, turning())) {
        Polynomial part = (*lift_)(coefficient);
        for (std::size_t unit = 0; unit < outer_.size(); ++unit) {
            int exponent = old.exponent(monomial, outer_[unit]);
            if (old.generator(outer_[unit]).kind == GeneratorKind::phase) {
                const bool conjugate = unit > 0 && outer_[unit - 1] == outer_[unit];
                exponent = std::max(conjugate ? -exponent : exponent, 0);
            }
            if (exponent > 0) part = ring_->multiply(part, power(unit, exponent));
        }
        parts.push_back(std::move(part));
    }
    return split(*ring_, sum(parts));
}

std::vector<RealForm::Harmonic> RealForm::harmonics(const Polynomial& p) const {
    const Ring& old = *field_.ring;
    std::vector<Harmonic> result;
    for (const auto& [monomial, coefficient] : old.collect(p, turning())) {
        Harmonic h;
        int weight = 0;
        for (const Mode& mode : field_.modes) {
            h.modes.emplace_back(old.exponent(monomial, mode.z),
                                 mode.is_real() ? 0 : old.exponent(monomial, mode.zbar));
            weight += old.generator(mode.z).weight * (h.modes.back().first + h.modes.back().second);
        }
        for (const AngleVariable& angle : field_.angles)
            h.angles.push_back(old.exponent(monomial, angle.phase));
        h.coefficient = split(*ring_, ring_->multiply((*lift_)(coefficient), ring_->gen(eps_, weight)));
        result.push_back(std::move(h));
    }
    return result;
}

std::size_t RealForm::length(const Polynomial& p) const {
    const Ring& old = *field_.ring;
    std::size_t length = 0;
    for (const auto& [monomial, coefficient] : old.collect(p, turning())) {
        std::size_t terms = coefficient.size();
        for (const GeneratorId id : turning())
            terms *= static_cast<std::size_t>(std::abs(old.exponent(monomial, id))) + 1;
        length += terms;
    }
    return length;
}

} // namespace resonform
