// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of any precision as a domain of coefficients for the series of a ring: fast variables, eps and
// phases stand in keys, all other generators have values.
//
//   ring: z1, z2, eps, s = 2^(1/2)      part:  s/4 z1 z2  ->  {key(z1 z2): 0.35355339059327376... +- 1e-60}
//
// All coefficients are balls, so that their accuracy is known at the end.
#pragma once

#include "algebra/graph/keyed_part.hpp"
#include "algebra/graph/outer_monomials.hpp"
#include "algebra/number/complex_ball.hpp"
#include "algebra/ring/ring.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace resonform {

using NumberPart = KeyedPart<WideKey, RealBall>;

// Values that are not exact in the ring.
struct GivenNumbers {
    std::map<GeneratorId, RealBall> generators;
    std::vector<ComplexBall> numbers; // those of SeriesProgram::number
};

// Copies share the values.
class NumberDomain {
public:
    using Part = NumberPart;

    // Every generator that occurs outside of keys has a value: those given, roots, and elementary functions.
    // Series have exponents up to `largest`. Errors (refused): a monomial does not fit into a word.
    NumberDomain(RingPtr ring, int largest, std::int64_t bits, GivenNumbers given);

    [[nodiscard]] std::int64_t bits() const { return state_->bits; }
    [[nodiscard]] const OuterMonomials<WideKey>& monomials() const { return state_->monomials; }
    [[nodiscard]] bool has_value(GeneratorId id) const {
        return state_->values[static_cast<std::size_t>(id)].has_value();
    }
    // Of a polynomial in generators without keys, and i. Errors (refused): one of them has no value.
    [[nodiscard]] ComplexBall value(const Polynomial& p) const;

    // --- as every domain -----------------------------------------------------------------------
    [[nodiscard]] Part constant(const Polynomial& p) const;
    [[nodiscard]] Part number(std::size_t k) const { return constant(state_->given.numbers[k]); }
    [[nodiscard]] Part one() const;
    [[nodiscard]] Part reduce(Part p) const { return p; }
    [[nodiscard]] Part dot(const std::vector<ProductOf<Part>>& products) const;
    [[nodiscard]] Part combination(const std::vector<std::pair<Rational, const Part*>>& addends) const;
    // Of a part without keys but i; nullopt if it may be zero (is not proved positive).
    [[nodiscard]] std::optional<Part> inverse(const Part& p) const;
    [[nodiscard]] std::optional<Part> rational_power(const Part& p, const Rational& exponent) const;
    // Whether the balls contain 0 or 1: an exact 0 or 1 of the ring may have a radius here.
    [[nodiscard]] bool is_zero(const Part& p) const;
    [[nodiscard]] bool is_one(const Part& p) const;
    [[nodiscard]] Part conjugate(const Part& p) const { return conjugated(keys(), p); }
    [[nodiscard]] Part derivative(const Part& p, GeneratorId id) const;
    [[nodiscard]] Part angle_derivative(const Part& p, GeneratorId phase) const;
    [[nodiscard]] Part without_vanishing(Part p, const std::vector<GeneratorId>& /*outer*/) const {
        return p;
    }
    // A part of this weight without its terms linear in fast variables of this weight.
    [[nodiscard]] Part without_linear(const Part& p, int weight) const;
    template <class ShareOf>
    [[nodiscard]] std::vector<Part> split(const Part& p, const std::vector<GeneratorId>& outer,
                                          ShareOf share_of) const {
        const Ring& ring = *monomials().ring();
        return shares_of(
            p, [&](WideKey key) { return share_of(ring.restricted(monomials().monomial(key), outer)); });
    }

    [[nodiscard]] Part constant(const ComplexBall& c) const;

private:
    struct State {
        OuterMonomials<WideKey> monomials;
        std::int64_t bits;
        GivenNumbers given;
        std::vector<std::optional<RealBall>> values = {}; // by generator
    };
    [[nodiscard]] const OuterKeysOf<WideKey>& keys() const { return state_->monomials.keys(); }
    void find_values();
    [[nodiscard]] const RealBall& value_of(GeneratorId id) const;
    [[nodiscard]] RealBall times(int number, const RealBall& c) const;

    std::shared_ptr<State> state_;
};

} // namespace resonform
