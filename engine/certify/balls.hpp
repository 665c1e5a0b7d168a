// SPDX-License-Identifier: GPL-3.0-or-later
// The program of a certificate at a point, over complex balls: truncated series in a grading variable t as in
// PointRun, each coefficient with the sum of the magnitudes of all terms that it was made of. A residual
// smaller than 10^-(digits + spare_digits/2) times this sum counts as rounding error.
#pragma once

#include "algebra/number/magnitude.hpp"
#include "certify/points/plan.hpp"

#include <random>
#include <vector>

namespace resonform {

// A value for each generator, and for its conjugate: modes with their conjugates, phases and eps are free, of
// the size of 1; roots and functions have their values.
struct BallPoint {
    std::vector<ComplexBall> values, conjugates;
    std::int64_t bits;
};
BallPoint random_ball_point(const RingPtr& ring, std::mt19937_64& random, std::int64_t bits);

class BallRun {
public:
    struct Coefficient {
        ComplexBall value;
        Magnitude size;

        void add(const Coefficient& other, std::int64_t bits) {
            acb_add(value.get(), value.get(), other.value.get(), bits);
            size.add(other.size);
        }
    };
    using Value = std::vector<Coefficient>; // of t^0 ... t^through

    // Series are known through weight M of the normal form.
    BallRun(const CertificatePlan& plan, const NormalForm& normal_form, const NearIdentityMap& map,
            const BallPoint& point);

    [[nodiscard]] const Value& operator()(Slot slot) const { return slots_[static_cast<std::size_t>(slot)]; }

private:
    [[nodiscard]] Value run(const Instruction& step) const; // a step that reads no series
    [[nodiscard]] Value constant(const ComplexBall& c) const;
    [[nodiscard]] Value number(const Rational& value) const;
    [[nodiscard]] Value generator(GeneratorId id, int power) const;
    [[nodiscard]] Value add(const Value& a, const Value& b) const;
    [[nodiscard]] Value multiply(const Value& a, const Value& b) const;
    // Plain Taylor sums; u_0 is 0 (1 for the logarithm) up to rounding.
    [[nodiscard]] Value integral(Value u, const Value& slope) const;
    [[nodiscard]] Value function(Function function, const Value& u) const;
    [[nodiscard]] Value power(const Value& a, const Rational& exponent, const Value& lead) const;
    [[nodiscard]] Value inverse_power(const Value& a, int n) const;
    // sum_k coefficients[k] u^k with u_0 = 0
    [[nodiscard]] Value taylor(const std::vector<Rational>& coefficients, Value u) const;
    [[nodiscard]] Value value(const Series& s, Side side) const;
    [[nodiscard]] Value slope(const Series& s, Side side, GeneratorId by) const;
    [[nodiscard]] const ComplexBall& value_of(GeneratorId id, Side side) const;
    // The value of a term divided by one power of the generator `without` (-1: undivided).
    [[nodiscard]] ComplexBall term(const Term& t, Side side, GeneratorId without) const;

    const Ring& ring_;
    const BallPoint& point_;
    int through_;
    std::int64_t bits_;
    std::vector<Value> slots_;
};

} // namespace resonform
