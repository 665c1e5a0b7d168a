// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_point.hpp"

#include "algebra/fractions.hpp"

#include <cstdlib>
#include <utility>

namespace resonform {

PointAlgebra::PointAlgebra(const Ring& ring, Point point, int through)
    : ring_(ring), point_(std::move(point)), through_(through) {}

Residue PointAlgebra::residue(const Rational& value) const {
    const std::optional<Residue> r = field().from(value);
    if (!r) throw UnluckyPoint();
    return *r;
}

PointAlgebra::Value PointAlgebra::constant(Residue value) const {
    Value result(static_cast<std::size_t>(through_) + 1, 0);
    result[0] = value;
    return result;
}

PointAlgebra::Value PointAlgebra::number(const Rational& value) const { return constant(residue(value)); }

PointAlgebra::Value PointAlgebra::generator(GeneratorId id, int power) const {
    Value result(static_cast<std::size_t>(through_) + 1, 0);
    const int weight = ring_.generator(id).weight * power;
    if (weight >= 0 && weight <= through_)
        result[static_cast<std::size_t>(weight)] =
            field().power(point_.values[static_cast<std::size_t>(id)], power);
    return result;
}

PointAlgebra::Value PointAlgebra::add(const Value& a, const Value& b) const {
    Value result(a.size());
    for (std::size_t n = 0; n < a.size(); ++n) result[n] = field().add(a[n], b[n]);
    return result;
}

PointAlgebra::Value PointAlgebra::multiply(const Value& a, const Value& b) const {
    Value result(a.size(), 0);
    for (std::size_t j = 0; j < a.size(); ++j) {
        if (a[j] == 0) continue;
        for (std::size_t n = j; n < a.size(); ++n)
            result[n] = field().add(result[n], field().multiply(a[j], b[n - j]));
    }
    return result;
}

PointAlgebra::Value PointAlgebra::taylor(const std::vector<Residue>& coefficients, const Value& u) const {
    Value result = constant(coefficients.back());
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
        result = multiply(result, u);
        result[0] = field().add(result[0], coefficients[k]);
    }
    return result;
}

std::vector<Residue> PointAlgebra::binomial(const Rational& exponent) const {
    std::vector<Residue> c{1};
    for (int k = 1; k <= through_; ++k)
        c.push_back(field().multiply(c.back(), residue((exponent - (k - 1)) / k)));
    return c;
}

std::vector<Residue> PointAlgebra::taylor_coefficients(Elementary function) const {
    const bool alternating =
        function == Elementary::sine || function == Elementary::cosine || function == Elementary::arc_tangent;
    std::vector<Residue> c;
    Rational factorial = 1, central = 1; // k!, and binomial(2j, j)/4^j with j = (k - 1)/2
    for (int k = 0; k <= through_; ++k) {
        const bool odd = k % 2 != 0;
        if (k > 0) factorial = factorial * k;
        if (odd && k > 1) central = central * (k - 2) / (k - 1);
        Rational value = 0;
        switch (function) {
        case Elementary::exponential: value = 1 / factorial; break;
        case Elementary::sine:
        case Elementary::hyperbolic_sine: value = odd ? 1 / factorial : 0; break;
        case Elementary::cosine:
        case Elementary::hyperbolic_cosine: value = odd ? 0 : 1 / factorial; break;
        case Elementary::arc_tangent: value = odd ? Rational(1) / k : 0; break;
        case Elementary::arc_sine: value = odd ? central / k : 0; break;
        case Elementary::logarithm: value = k == 0 ? Rational(0) : Rational(odd ? 1 : -1) / k; break;
        case Elementary::tangent:
        case Elementary::hyperbolic_tangent: break; // quotients, see function()
        }
        c.push_back(residue(alternating && k % 4 >= 2 ? -value : value));
    }
    return c;
}

PointAlgebra::Value PointAlgebra::function(Elementary function, const Value& u) const {
    if (function == Elementary::tangent || function == Elementary::hyperbolic_tangent) {
        const bool circular = function == Elementary::tangent;
        return multiply(
            this->function(circular ? Elementary::sine : Elementary::hyperbolic_sine, u),
            inverse_power(this->function(circular ? Elementary::cosine : Elementary::hyperbolic_cosine, u),
                          1));
    }
    Value shifted = u;
    if (function == Elementary::logarithm) shifted[0] = field().subtract(u[0], 1);
    if (shifted[0] != 0)
        refuse({"a Taylor sum is taken where its argument vanishes at the origin (is 1 for log)",
                "weight 0 of an argument",
                "write the argument so that its value at the origin is plain",
                {}});
    return taylor(taylor_coefficients(function), shifted);
}

PointAlgebra::Value PointAlgebra::power(const Value& a, const Rational& exponent, const Value& lead) const {
    if (a[0] == 0) throw UnluckyPoint();
    Value ratio = multiply(a, constant(field().inverse(a[0])));
    ratio[0] = 0;
    return multiply(lead, taylor(binomial(exponent), ratio));
}

PointAlgebra::Value PointAlgebra::inverse_power(const Value& a, int n) const {
    if (a[0] == 0) throw UnluckyPoint();
    return power(a, -n, constant(field().power(a[0], -n)));
}

Residue PointAlgebra::value_of(GeneratorId id, Side side) const {
    const GeneratorId partner = ring_.generator(id).conjugate;
    const bool swapped = side == Side::conjugate && partner >= 0;
    const Residue value = point_.values[static_cast<std::size_t>(swapped ? partner : id)];
    if (side == Side::itself) return value;
    if (ring_.generator(id).kind == GeneratorKind::phase) return field().inverse(value);
    return id == Ring::imaginary_unit ? field().negate(value) : value;
}

namespace {

// Powers of one value, negative ones included, each computed once.
class Powers {
public:
    Powers(const PrimeField& field, Residue value) : field_(field), value_(value) {}

    Residue operator()(int exponent) {
        std::vector<Residue>& known = exponent < 0 ? negative_ : positive_;
        const auto n = static_cast<std::size_t>(std::abs(exponent));
        if (known.empty()) known.push_back(1);
        if (known.size() <= n && exponent < 0 && known.size() == 1) inverse_ = field_.inverse(value_);
        while (known.size() <= n)
            known.push_back(field_.multiply(known.back(), exponent < 0 ? inverse_ : value_));
        return known[n];
    }

private:
    const PrimeField& field_;
    Residue value_, inverse_ = 0;
    std::vector<Residue> positive_, negative_;
};

} // namespace

Gradient<PointAlgebra::Value> PointAlgebra::gradient(const Series& s, Side side) const {
    const PrimeField& f = field();
    const auto size = static_cast<std::size_t>(ring_.size());
    std::vector<Powers> powers;
    for (GeneratorId id = 0; id < ring_.size(); ++id) powers.emplace_back(f, value_of(id, side));
    Gradient<Value> result{constant(0), {}};
    std::vector<Value> slopes(size); // g ds/dg: by weight of the term
    std::vector<std::pair<std::size_t, int>> present;
    for (int n = 0; n <= through_; ++n) {
        const Fractions& part = s.part(n).fractions();
        const Residue cofactor = inverse_of_denominator(part);
        for (std::size_t k = 0; k < part.size(); ++k) {
            Residue value = f.multiply(cofactor, f.from_limbs(part.magnitude(k), part.limbs));
            if (part.negative[k] != 0) value = f.negate(value);
            present.clear();
            for (std::size_t id = 0; id < size; ++id) {
                const int e = ring_.exponent(part.monomials[k], static_cast<GeneratorId>(id));
                if (e == 0) continue;
                present.emplace_back(id, e);
                value = f.multiply(value, powers[id](e));
            }
            Residue& total = result.value[static_cast<std::size_t>(n)];
            total = f.add(total, value);
            for (const auto& [id, e] : present) {
                const int weight = n - ring_.generator(static_cast<GeneratorId>(id)).weight;
                if (slopes[id].empty()) slopes[id] = constant(0);
                Residue& slope = slopes[id][static_cast<std::size_t>(weight)];
                slope = f.add(slope, f.multiply(value, f.from(e)));
            }
        }
    }
    for (std::size_t id = 0; id < size; ++id) {
        if (slopes[id].empty()) continue;
        result.slopes.emplace_back(static_cast<GeneratorId>(id),
                                   multiply(slopes[id], constant(powers[id](-1))));
    }
    return result;
}

Residue PointAlgebra::inverse_of_denominator(const Fractions& part) const {
    const mpz_srcptr denominator = part.denominator.get_mpz_t();
    const Residue residue = field().from_limbs(mpz_limbs_read(denominator), mpz_size(denominator));
    if (residue == 0) throw UnluckyPoint();
    return field().inverse(residue);
}

} // namespace resonform
