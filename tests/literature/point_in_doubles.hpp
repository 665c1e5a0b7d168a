// SPDX-License-Identifier: GPL-3.0-or-later
// Values of normal forms in double precision, by what their generators mean: they compare forms over
// different rings. What is given no value (modes, slow variables, functions known by name) gets one by its
// name.
#pragma once

#include "algebra/number/functions.hpp"
#include "algebra/number/real_ball.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <vector>

namespace resonform::test {

class PointInDoubles {
public:
    using Value = std::complex<double>;

    // given: of every parameter, and of slow variables.
    PointInDoubles(const Ring& ring, const std::map<std::string, double>& given) : ring_(ring) {
        for (GeneratorId id = 0; id < ring.size(); ++id) values_.push_back(value_of(id, given));
    }

    [[nodiscard]] Value operator()(const Polynomial& p) const {
        Value sum = 0;
        for (const Term& term : p.terms()) {
            Value product = cln::double_approx(term.coefficient);
            for (std::size_t id = 0; id < values_.size(); ++id)
                product *= std::pow(values_[id], ring_.exponent(term.monomial, static_cast<GeneratorId>(id)));
            sum += product;
        }
        return sum;
    }

private:
    // Between 1/2 and 3/2.
    static double by_name(const std::string& name) {
        double phase = 0;
        for (const char c : name) phase = 1.7 * phase + c;
        return 1 + std::sin(phase) / 2;
    }

    [[nodiscard]] Value value_of(GeneratorId id, const std::map<std::string, double>& given) const {
        const Generator& g = ring_.generator(id);
        switch (g.kind) {
        case GeneratorKind::imaginary: return {0, 1};
        case GeneratorKind::fast:
            if (g.conjugate < 0) return by_name(g.name);
            if (g.conjugate < id) return std::conj(values_[static_cast<std::size_t>(g.conjugate)]);
            return std::polar(by_name(g.name), by_name(g.name + "'"));
        case GeneratorKind::parameter: return given.at(g.name);
        case GeneratorKind::phase: return std::polar(1.0, by_name(g.name));
        case GeneratorKind::root: return std::pow((*this)(g.radicand).real(), 1.0 / g.index);
        case GeneratorKind::function: return function(g.of);
        default: {
            const auto found = given.find(g.name);
            return found == given.end() ? by_name(g.name) : found->second;
        }
        }
    }

    [[nodiscard]] Value function(const FunctionOf& of) const {
        if (of.function == Function::named) return by_name(of.symbol + std::to_string(of.derivative));
        RealBall value;
        arb_set_d(value.get(), (*this)(of.argument).real());
        row_of(of.function).enclose(value.get(), value.get(), 64);
        return nearest_double(value);
    }

    const Ring& ring_;
    std::vector<Value> values_;
};

// Both through the same weight, of the same variables.
inline void expect_same_values(const Normalization& a, const Normalization& b,
                               const std::map<std::string, double>& parameters) {
    const PointInDoubles at_a(*a.normal_form.field->ring, parameters),
        at_b(*b.normal_form.field->ring, parameters);
    const auto compare = [&](const std::vector<Series>& left, const std::vector<Series>& right,
                             const std::string& what) {
        ASSERT_EQ(left.size(), right.size());
        for (std::size_t k = 0; k < left.size(); ++k)
            for (int n = 0; n <= std::max(left[k].through(), right[k].through()); ++n) {
                const auto expected = at_a(left[k].part(n)), found = at_b(right[k].part(n));
                EXPECT_LE(std::abs(expected - found), 1e-9 * (1 + std::abs(expected)))
                    << what << " " << k << ", weight " << n << ": " << expected << ", " << found;
            }
    };
    compare(a.normal_form.mode, b.normal_form.mode, "rate of mode");
    compare(a.normal_form.angle, b.normal_form.angle, "rate of angle");
    compare(a.normal_form.slow, b.normal_form.slow, "rate of slow variable");
    compare(a.normal_form.drift, b.normal_form.drift, "rate of drift");
    compare(a.map.mode, b.map.mode, "map of mode");
    compare(a.map.angle, b.map.angle, "map of angle");
    compare(a.map.slow, b.map.slow, "map of slow variable");
    compare(a.map.drift, b.map.drift, "map of drift");
}

} // namespace resonform::test
