// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/shifted_series.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/functions.hpp"

#include <algorithm>

namespace resonform {

using Node = SeriesProgram::Node;

ShiftedSeries::ShiftedSeries(const GradedField& field) : field_(field), program_(field.ring) {
    const auto add = [&](GeneratorId id) {
        inputs_[id] = program_.input(field.ring->generator(id).name);
        moving_.push_back(id);
    };
    for (const Mode& m : field.modes) {
        add(m.z);
        if (!m.is_real()) add(m.zbar);
    }
    for (const AngleVariable& a : field.angles) add(a.phase);
    for (const SlowVariable& s : field.slow)
        if (s.driven) add(s.generator);
    for (GeneratorId id = 0; id < field.ring->size(); ++id) {
        const Generator& g = field.ring->generator(id);
        if (g.kind != GeneratorKind::root && g.kind != GeneratorKind::function) continue;
        const Polynomial& inside = g.kind == GeneratorKind::root ? g.radicand : g.of.argument;
        const std::vector<Monomial>& monomials = inside.fractions().monomials;
        if (std::any_of(monomials.begin(), monomials.end(), [&](const Monomial& m) {
                return std::any_of(moving_.begin(), moving_.end(),
                                   [&](GeneratorId moved) { return field.ring->exponent(m, moved) != 0; });
            }))
            moving_.push_back(id);
    }
}

void ShiftedSeries::set(SeriesRun& run, const NearIdentityMap& shift, int weight) const {
    const Ring& ring = *field_.ring;
    const auto value = [&](GeneratorId id, const Series& s) {
        return ring.generator(id).weight == weight ? ring.gen(id) + s.part(weight) : s.part(weight);
    };
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const Mode& m = field_.modes[k];
        const Polynomial z = value(m.z, shift.mode[k]);
        run.set_input(inputs_.at(m.z), weight, z);
        if (!m.is_real()) run.set_input(inputs_.at(m.zbar), weight, ring.conjugate(z));
    }
    for (std::size_t k = 0; k < field_.angles.size(); ++k)
        run.set_input(inputs_.at(field_.angles[k].phase), weight, shift.angle[k].part(weight));
    for (std::size_t k = 0; k < field_.slow.size(); ++k)
        if (const SlowVariable& s = field_.slow[k]; s.driven)
            run.set_input(inputs_.at(s.generator), weight, value(s.generator, shift.slow[k]));
}

bool ShiftedSeries::moves(GeneratorId id) const {
    return std::find(moving_.begin(), moving_.end(), id) != moving_.end();
}

// Sum over the monomials in moving generators: coefficient * product of powers. The powers first: equal
// products of powers are shared between all series.
Node ShiftedSeries::add(const Polynomial& p) {
    const Ring& ring = *field_.ring;
    std::vector<std::pair<Rational, Node>> addends;
    for (const auto& [monomial, coefficient] : ring.collect(p, moving_)) {
        Node product = program_.constant(ring.one());
        for (const GeneratorId id : moving_)
            if (const int exponent = ring.exponent(monomial, id); exponent != 0)
                product = program_.product(product, power(id, exponent));
        addends.emplace_back(1, program_.product(program_.constant(coefficient), product));
    }
    return program_.sum(addends);
}

// Natural powers by one factor after the other: all lower powers occur anyway, and equal nodes are shared.
Node ShiftedSeries::power(GeneratorId id, int exponent) {
    const Generator& g = field_.ring->generator(id);
    if (g.kind == GeneratorKind::phase) return turned(id, exponent);
    if (g.kind == GeneratorKind::root) return program_.power(add(g.radicand), Rational(exponent) / g.index);
    const Node base = g.kind == GeneratorKind::function ? function(id) : inputs_.at(id);
    if (exponent < 0) return program_.power(base, exponent);
    Node result = base;
    for (int k = 1; k < exponent; ++k) result = program_.product(result, base);
    return result;
}

// f(u) of the shifted argument u = u_0 + rest: by addition theorems, or f(u_0) + int f'(u) du, weight by
// weight.
Node ShiftedSeries::function(GeneratorId id) {
    const Ring& ring = *field_.ring;
    const FunctionOf& of = ring.generator(id).of;
    const Node u = add(of.argument), here = program_.constant(ring.gen(id));
    const Node rest = program_.sum({{1, u}, {-1, program_.constant(of.argument)}});
    const auto turned = [&](GeneratorId other, int sign) { // here cos(rest) + sign other sin(rest)
        const Node beside = program_.product(program_.constant(ring.gen(other)), program_.sine(rest));
        return program_.sum({{1, program_.product(here, program_.cosine(rest))}, {sign, beside}});
    };
    const auto integral = [&](Node slope) {
        return program_.sum({{1, here}, {1, program_.antiderivative(u, slope)}});
    };
    switch (of.function) {
    case Function::exponential: return program_.product(here, program_.exponential(rest));
    case Function::cosine: return turned(of.sine, -1);
    case Function::sine: return turned(cosine_beside(id), 1);
    case Function::logarithm: return integral(program_.power(u, -1));
    case Function::arc_tangent: {
        const Node one = program_.constant(ring.one());
        return integral(program_.power(program_.sum({{1, one}, {1, program_.product(u, u)}}), -1));
    }
    default: break;
    }
    if (!of.slope)
        refuse({"a map is inverted where its functions can be expanded",
                ring.generator(id).name,
                "write an expression in its place",
                {field_.system().file.string(), 0, 0, "equations", ""}});
    return integral(add(*of.slope));
}

GeneratorId ShiftedSeries::cosine_beside(GeneratorId sine) const {
    GeneratorId id = sine;
    while (field_.ring->generator(id).kind != GeneratorKind::function ||
           field_.ring->generator(id).of.function != Function::cosine ||
           field_.ring->generator(id).of.sine != sine)
        ++id;
    return id;
}

// e^{i k (phi + m)} = e^{i k phi} e^{i k m}
Node ShiftedSeries::turned(GeneratorId phase, int exponent) {
    const Polynomial turn = Rational(exponent) * field_.ring->imaginary();
    const Node shift = program_.product(program_.constant(turn), inputs_.at(phase));
    return program_.product(program_.constant(field_.ring->gen(phase, exponent)),
                            program_.exponential(shift));
}

} // namespace resonform
