// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/balls.hpp"

#include "algebra/number/taylor_law.hpp"
#include "algebra/series/number_domain.hpp"
#include "certify/points/readings.hpp"

#include <stdexcept>
#include <utility>

namespace resonform {

namespace {

// A random number of 60 bits with a real part between 1/2 and 3/4 and an imaginary part below 1/4.
ComplexBall random_value(std::mt19937_64& random, bool real) {
    constexpr int bits = 60;
    constexpr std::int64_t half = std::int64_t{1} << (bits - 1), quarter = half / 2;
    const auto draw = [&](std::int64_t low, std::int64_t width) {
        RealBall part(low + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(width)));
        arb_mul_2exp_si(part.get(), part.get(), -bits);
        return part;
    };
    const RealBall re = draw(half, quarter);
    return {re, real ? RealBall() : draw(-quarter, half)};
}

ComplexBall power_of(const ComplexBall& c, int n, std::int64_t bits) {
    ComplexBall result;
    acb_pow_si(result.get(), c.get(), n, bits);
    return result;
}

// c_0 ... c_through of the function at 0 (log: of log(1 + u)); tan and tanh are quotients and have none here.
std::vector<Rational> taylor_coefficients(Function function, int through) {
    const TaylorLaw law = taylor_law(function);
    std::vector<Rational> c;
    Rational factorial = 1, central = 1; // k!, and binomial(2j, j)/4^j with j = (k - 1)/2
    for (int k = 0; k <= through; ++k) {
        const bool odd = k % 2 != 0;
        if (k > 0) factorial = factorial * k;
        if (odd && k > 1) central = central * (k - 2) / (k - 1);
        Rational value = 0;
        if (law.has(k))
            value = law.kind == TaylorLaw::factorial    ? 1 / factorial
                    : law.kind == TaylorLaw::reciprocal ? Rational(1) / k
                                                        : central / k;
        c.push_back(law.negative(k) ? -value : value);
    }
    return c;
}

std::vector<Rational> binomial_coefficients(const Rational& exponent, int through) {
    std::vector<Rational> c{1};
    for (int k = 1; k <= through; ++k) c.push_back(c.back() * (exponent - (k - 1)) / k);
    return c;
}

} // namespace

BallPoint random_ball_point(const RingPtr& ring, std::mt19937_64& random, std::int64_t bits) {
    BallPoint point{std::vector<ComplexBall>(static_cast<std::size_t>(ring->size())), {}, bits};
    const NumberDomain numbers(ring, 1, bits, {});
    for (GeneratorId id = 0; id < ring->size(); ++id) {
        ComplexBall& value = point.values[static_cast<std::size_t>(id)];
        switch (ring->generator(id).kind) {
        case GeneratorKind::imaginary: value = ComplexBall(RealBall(), RealBall(1)); break;
        case GeneratorKind::fast:
        case GeneratorKind::phase: value = random_value(random, false); break;
        case GeneratorKind::small: value = random_value(random, true); break;
        default: // roots and functions of numbers; modes and frequencies were rounded
            if (numbers.has_value(id)) value = numbers.value(ring->gen(id));
        }
    }
    for (GeneratorId id = 0; id < ring->size(); ++id) {
        const Generator& g = ring->generator(id);
        const ComplexBall& own = point.values[static_cast<std::size_t>(id)];
        point.conjugates.push_back(g.kind == GeneratorKind::phase ? power_of(own, -1, bits)
                                   : id == Ring::imaginary_unit   ? own.negative()
                                   : g.conjugate >= 0 ? point.values[static_cast<std::size_t>(g.conjugate)]
                                                      : own);
    }
    return point;
}

BallRun::BallRun(const CertificatePlan& plan, const NormalForm& normal_form, const NearIdentityMap& map,
                 const BallPoint& point)
    : ring_(*normal_form.field->ring), point_(point), through_(normal_form.through), bits_(point.bits) {
    const std::vector<Instruction>& steps = plan.program.steps();
    slots_.resize(steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (!plan.needed[k]) continue;
        const Instruction& step = steps[k];
        const auto series = [&]() -> const Series& {
            return series_of(step.series, plan.program, normal_form, map);
        };
        if (step.operation == Operation::value)
            slots_[k] = value(series(), step.side);
        else if (step.operation == Operation::slope)
            slots_[k] = slope(series(), step.side, step.index);
        else
            slots_[k] = run(step);
    }
}

BallRun::Value BallRun::run(const Instruction& step) const {
    const auto operand = [&](Slot slot) -> const Value& { return (*this)(slot); };
    switch (step.operation) {
    case Operation::number: return number(step.number);
    case Operation::generator: return generator(step.index, step.power);
    case Operation::add: return add(operand(step.left), operand(step.right));
    case Operation::multiply: return multiply(operand(step.left), operand(step.right));
    case Operation::function: return function(static_cast<Function>(step.index), operand(step.left));
    case Operation::power: return power(operand(step.left), step.number, operand(step.right));
    case Operation::inverse_power: return inverse_power(operand(step.left), step.index);
    case Operation::integral: return integral(operand(step.left), operand(step.right));
    case Operation::at_origin: {
        Value result(operand(step.left).size());
        result[0] = operand(step.left)[0];
        return result;
    }
    case Operation::value:
    case Operation::slope: break;
    }
    throw std::logic_error("BallRun: a step that reads a series");
}

const ComplexBall& BallRun::value_of(GeneratorId id, Side side) const {
    return (side == Side::itself ? point_.values : point_.conjugates)[static_cast<std::size_t>(id)];
}

BallRun::Value BallRun::constant(const ComplexBall& c) const {
    Value result(static_cast<std::size_t>(through_) + 1);
    result[0] = {c, Magnitude(c)};
    return result;
}

BallRun::Value BallRun::number(const Rational& value) const {
    return constant({RealBall(value, bits_), RealBall()});
}

BallRun::Value BallRun::generator(GeneratorId id, int power) const {
    Value result(static_cast<std::size_t>(through_) + 1);
    const int weight = ring_.generator(id).weight * power;
    if (weight < 0 || weight > through_) return result;
    const ComplexBall value = power_of(value_of(id, Side::itself), power, bits_);
    result[static_cast<std::size_t>(weight)] = {value, Magnitude(value)};
    return result;
}

BallRun::Value BallRun::add(const Value& a, const Value& b) const {
    Value result = a;
    for (std::size_t n = 0; n < a.size(); ++n) result[n].add(b[n], bits_);
    return result;
}

BallRun::Value BallRun::multiply(const Value& a, const Value& b) const {
    Value result(a.size());
    for (std::size_t j = 0; j < a.size(); ++j) {
        if (a[j].size.is_zero()) continue;
        for (std::size_t n = j; n < a.size(); ++n) {
            acb_addmul(result[n].value.get(), a[j].value.get(), b[n - j].value.get(), bits_);
            result[n].size.add_product(a[j].size, b[n - j].size);
        }
    }
    return result;
}

BallRun::Value BallRun::taylor(const std::vector<Rational>& coefficients, Value u) const {
    u[0] = {};
    Value result = number(coefficients.back());
    for (std::size_t k = coefficients.size() - 1; k-- > 0;)
        result = add(multiply(result, u), number(coefficients[k]));
    return result;
}

BallRun::Value BallRun::integral(Value u, const Value& slope) const {
    const auto scaled = [&](Value value, const auto& factor) {
        for (std::size_t n = 0; n < value.size(); ++n) {
            Value one(value.size());
            one[n] = value[n];
            value[n] = multiply(one, number(factor(static_cast<long>(n))))[n];
        }
        return value;
    };
    const Value product = multiply(scaled(std::move(u), [](long n) { return Rational(n); }), slope);
    return scaled(product, [](long n) { return n == 0 ? Rational(0) : Rational(1) / Rational(n); });
}

BallRun::Value BallRun::function(Function function, const Value& u) const {
    const auto quotient_of = [&](Function above, Function below) {
        return multiply(this->function(above, u), inverse_power(this->function(below, u), 1));
    };
    if (function == Function::tangent) return quotient_of(Function::sine, Function::cosine);
    if (function == Function::hyperbolic_tangent)
        return quotient_of(Function::hyperbolic_sine, Function::hyperbolic_cosine);
    return taylor(taylor_coefficients(function, through_), u);
}

BallRun::Value BallRun::power(const Value& a, const Rational& exponent, const Value& lead) const {
    return multiply(lead, taylor(binomial_coefficients(exponent, through_),
                                 multiply(a, constant(power_of(a[0].value, -1, bits_)))));
}

BallRun::Value BallRun::inverse_power(const Value& a, int n) const {
    return power(a, -n, constant(power_of(a[0].value, -n, bits_)));
}

ComplexBall BallRun::term(const Term& t, Side side, GeneratorId without) const {
    ComplexBall product(RealBall(t.coefficient, bits_), RealBall());
    const std::vector<int> exponents = ring_.exponents(t.monomial);
    for (std::size_t k = 0; k < exponents.size(); ++k) {
        const auto id = static_cast<GeneratorId>(k);
        const int n = exponents[k] - (id == without ? 1 : 0);
        if (n != 0) product = times(product, power_of(value_of(id, side), n, bits_), bits_);
    }
    return product;
}

BallRun::Value BallRun::value(const Series& s, Side side) const {
    Value result(static_cast<std::size_t>(through_) + 1);
    for (int n = 0; n <= through_; ++n) {
        Coefficient& sum = result[static_cast<std::size_t>(n)];
        for (const Term& t : s.part(n).terms()) {
            const ComplexBall value = term(t, side, -1);
            sum.add({value, Magnitude(value)}, bits_);
        }
    }
    return result;
}

BallRun::Value BallRun::slope(const Series& s, Side side, GeneratorId by) const {
    Value result(static_cast<std::size_t>(through_) + 1);
    for (int n = ring_.generator(by).weight; n <= through_; ++n) {
        Coefficient& sum = result[static_cast<std::size_t>(n - ring_.generator(by).weight)];
        for (const Term& t : s.part(n).terms()) {
            const int exponent = ring_.exponent(t.monomial, by);
            if (exponent == 0) continue;
            const ComplexBall value = times(term(t, side, by), ComplexBall(exponent), bits_);
            sum.add({value, Magnitude(value)}, bits_);
        }
    }
    return result;
}

} // namespace resonform
