// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/real_form.hpp"

#include "algebra/ring/ring_copy.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace resonform {

namespace {

GeneratorId add_part(RingBuilder& builder, const char* part, const std::string& variable) {
    Generator g;
    g.kind = GeneratorKind::constant;
    g.name = fresh_name(builder, part + ("_" + variable));
    return builder.add(std::move(g));
}

RealForm::Pair add_pair(RingBuilder& builder, const std::string& variable, bool real) {
    const GeneratorId u = add_part(builder, "u", variable);
    return {u, real ? GeneratorId(-1) : add_part(builder, "v", variable)};
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
    for (const Mode& mode : field.modes)
        moduli_.push_back(mode.is_real() ? GeneratorId(-1)
                                         : add_part(builder, "modulus", name(mode.variable)));
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

RealForm::Value RealForm::operator()(const Polynomial& p, const std::vector<bool>& of_modulus) const {
    const Ring& old = *field_.ring;
    std::vector<Polynomial> parts;
    for (const auto& [given, coefficient] : old.collect(p, turning())) {
        Polynomial part = (*lift_)(coefficient);
        Monomial monomial = given;
        for (std::size_t k = 0; k < of_modulus.size(); ++k) {
            if (!of_modulus[k]) continue;
            const Mode& mode = field_.modes[k];
            const int pairs = std::min(old.exponent(given, mode.z), old.exponent(given, mode.zbar));
            if (pairs == 0) continue;
            monomial = monomial - old.monomial(mode.z, pairs) - old.monomial(mode.zbar, pairs);
            part = ring_->multiply(part, ring_->gen(moduli_[k], pairs));
            part = ring_->multiply(part, ring_->gen(eps_, 2 * pairs * old.generator(mode.z).weight));
        }
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
    std::map<std::vector<int>, std::vector<Polynomial>> parts;
    for (const auto& [monomial, coefficient] : old.collect(p, turning())) {
        std::vector<int> turns;
        int weight = 0;
        Polynomial still = ring_->one();
        for (std::size_t k = 0; k < modes_.size(); ++k) {
            const Mode& mode = field_.modes[k];
            const int z = old.exponent(monomial, mode.z);
            const int zbar = mode.is_real() ? z : old.exponent(monomial, mode.zbar);
            turns.push_back(z - zbar);
            weight += old.generator(mode.z).weight * (mode.is_real() ? z : z + zbar);
            if (const int power = std::min(z, zbar); power > 0)
                still = ring_->multiply(still, ring_->gen(mode.is_real() ? modes_[k].u : moduli_[k], power));
        }
        for (const AngleVariable& angle : field_.angles) turns.push_back(old.exponent(monomial, angle.phase));
        still = ring_->multiply(still, ring_->gen(eps_, weight));
        parts[turns].push_back(ring_->multiply((*lift_)(coefficient), still));
    }
    std::vector<Harmonic> result;
    for (const auto& [turns, list] : parts) result.push_back({turns, split(*ring_, sum(list))});
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
