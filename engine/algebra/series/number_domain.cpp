// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/series/number_domain.hpp"

#include "algebra/number/error.hpp"
#include "algebra/ring/enclosure.hpp"

#include <cln/integer.h>

#include <algorithm>

namespace resonform {

NumberDomain::NumberDomain(RingPtr ring, int largest, std::int64_t bits, GivenNumbers given)
    : state_(std::make_shared<State>(
          State{OuterMonomials<WideKey>(std::move(ring), largest), bits, std::move(given)})) {
    find_values();
}

// Radicands and arguments hold earlier generators only. A generator that cannot be evaluated gets no value;
// value_of() refuses it where it is used.
void NumberDomain::find_values() {
    const Ring& ring = *monomials().ring();
    const BallOf before = [&](GeneratorId id) -> auto& { return value_of(id); };
    state_->values.resize(static_cast<std::size_t>(ring.size()));
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        auto& value = state_->values[static_cast<std::size_t>(id)];
        const auto given = state_->given.generators.find(id);
        if (given != state_->given.generators.end())
            value = given->second;
        else
            value = enclose(ring, ring.generator(id), before, bits());
    }
}

const RealBall& NumberDomain::value_of(GeneratorId id) const {
    const auto& value = state_->values[static_cast<std::size_t>(id)];
    if (!value)
        refuse({"coefficients in numbers hold nothing but numbers",
                monomials().ring()->generator(id).name,
                "give every parameter its value with --set NAME=VALUE, or leave out --digits",
                {}});
    return *value;
}

ComplexBall NumberDomain::value(const Polynomial& p) const {
    const BallOf known = [&](GeneratorId id) -> auto& { return value_of(id); };
    return enclose(*monomials().ring(), p, known, bits());
}

NumberPart NumberDomain::constant(const ComplexBall& c) const {
    NumberPart part;
    if (const RealBall re = c.re(); !re.is_zero()) part.append(0, re);
    if (const RealBall im = c.im(); !im.is_zero()) part.append(OuterKeysOf<WideKey>::imaginary, im);
    part.real = equals_its_conjugate(keys(), part);
    return part;
}

NumberPart NumberDomain::constant(const Polynomial& p) const {
    const Ring& ring = *monomials().ring();
    std::vector<std::pair<WideKey, RealBall>> terms;
    for (const auto& [monomial, polynomial] : ring.collect(p, monomials().outer()))
        terms.emplace_back(monomials().key(monomial), value(polynomial).re());
    NumberPart part = part_of(std::move(terms));
    part.real = equals_its_conjugate(keys(), part);
    return part;
}

NumberPart NumberDomain::one() const { return constant(ComplexBall(1)); }

RealBall NumberDomain::times(int number, const RealBall& c) const {
    RealBall result;
    arb_mul_si(result.get(), c.get(), number, bits());
    return result;
}

NumberPart NumberDomain::derivative(const Part& p, GeneratorId id) const {
    const int field = monomials().field(id);
    if (field < 0) return {}; // numbers depend on nothing
    return derivative_of(keys(), p, field, [&](int k, const RealBall& c) { return times(k, c); });
}

NumberPart NumberDomain::angle_derivative(const Part& p, GeneratorId phase) const {
    return angle_derivative_of(keys(), p, monomials().field(phase),
                               [&](int k, const RealBall& c) { return times(k, c); });
}

// 1/(a + i b) = (a - i b)/(a^2 + b^2)
std::optional<NumberPart> NumberDomain::inverse(const Part& p) const {
    if (p.empty() || p.keys.back() > OuterKeysOf<WideKey>::imaginary) return std::nullopt;
    RealBall norm, quotient;
    for (const RealBall& c : p.coefficients) arb_addmul(norm.get(), c.get(), c.get(), bits());
    if (norm.contains_zero()) return std::nullopt;
    NumberPart result{{}, {}, p.real};
    for (std::size_t k = 0; k < p.size(); ++k) {
        arb_div(quotient.get(), p.coefficients[k].get(), norm.get(), bits());
        result.append(p.keys[k], OuterKeysOf<WideKey>::has_i(p.keys[k]) ? quotient.negative() : quotient);
    }
    return result;
}

std::optional<NumberPart> NumberDomain::rational_power(const Part& p, const Rational& exponent) const {
    if (cln::denominator(exponent) == 1 && cln::minusp(exponent)) {
        const auto reciprocal = inverse(p);
        if (!reciprocal) return std::nullopt;
        Part power = one();
        for (Integer k = 0; k < -cln::numerator(exponent); k = k + 1)
            power = dot({{1, &power, &*reciprocal}});
        return power;
    }
    if (p.size() != 1 || p.keys.front() != 0 || !p.coefficients.front().is_positive()) return std::nullopt;
    RealBall result;
    const RealBall power(exponent, bits());
    arb_pow(result.get(), p.coefficients.front().get(), power.get(), bits());
    return constant(ComplexBall(result, RealBall()));
}

bool NumberDomain::is_zero(const Part& p) const {
    return std::all_of(p.coefficients.begin(), p.coefficients.end(),
                       [](const RealBall& c) { return c.contains_zero(); });
}

bool NumberDomain::is_one(const Part& p) const {
    const Part unit = one();
    return is_zero(combination({{1, &p}, {-1, &unit}}));
}

NumberPart NumberDomain::without_linear(const Part& p, int weight) const {
    NumberPart result{{}, {}, p.real};
    const Ring& ring = *monomials().ring();
    for (std::size_t k = 0; k < p.size(); ++k) {
        const Monomial m = monomials().monomial(p.keys[k]);
        int degree = 0, own = 0;
        for (GeneratorId id = 1; id < ring.size(); ++id) {
            if (ring.generator(id).kind != GeneratorKind::fast) continue;
            degree += ring.exponent(m, id);
            if (ring.generator(id).weight == weight) own += ring.exponent(m, id);
        }
        if (degree != 1 || own != 1) result.append(p.keys[k], p.coefficients[k]);
    }
    return result;
}

} // namespace resonform
