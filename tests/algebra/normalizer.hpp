// SPDX-License-Identifier: GPL-3.0-or-later
// A second, small normaliser (fast equations, Poincare's style), over any domain of coefficients.
#pragma once

#include "oscillators.hpp"

#include <map>
#include <memory>
#include <vector>

namespace resonform::testing {

// What a domain must add for it: the part of p whose divisor i (k.w) vanishes, and the rest divided by it.
template <class Part> struct Solved { Part kept, divided; };

// Frequencies are symbols of the graph.
class GraphDivision {
public:
    using Domain = GraphDomain;
    GraphDivision(const OscillatorField& field, int largest) : domain(field.ring, largest), field_(&field) {}

    Solved<GraphPart> solve(const GraphPart& p, std::size_t mode) {
        Solved<GraphPart> result;
        result.kept.real = result.divided.real = false;
        for (std::size_t e = 0; e < p.size(); ++e) {
            std::vector<int> harmonics;
            for (std::size_t m = 0; m < field_->z.size(); ++m)
                harmonics.push_back(exponent(p.keys[e], 2 * m) - exponent(p.keys[e], 2 * m + 1) -
                                    (m == mode ? 1 : 0));
            if (std::all_of(harmonics.begin(), harmonics.end(), [](int k) { return k == 0; })) {
                result.kept.keys.push_back(p.keys[e]);
                result.kept.coefficients.push_back(p.coefficients[e]);
                continue;
            }
            // c/(i d) = -i c/d
            OuterKey key = p.keys[e] + OuterKeys::imaginary;
            const Coefficient c = domain.graph().product(p.coefficients[e], inverse(harmonics));
            divided_.emplace_back(key, c.negative());
            if (OuterKeys::take_square_of_i(divided_.back().first)) divided_.back().second = c;
        }
        std::sort(divided_.begin(), divided_.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [key, c] : divided_) {
            result.divided.keys.push_back(key);
            result.divided.coefficients.push_back(c);
        }
        divided_.clear();
        return result;
    }

    GraphDomain domain;

private:
    [[nodiscard]] int exponent(OuterKey key, std::size_t field) const {
        return domain.arithmetic().keys().exponent(key, static_cast<int>(field));
    }
    Coefficient inverse(const std::vector<int>& harmonics) {
        const auto [known, fresh] = inverses_.emplace(harmonics, Coefficient());
        if (fresh) {
            Polynomial divisor;
            for (std::size_t m = 0; m < harmonics.size(); ++m)
                divisor = divisor + Rational(harmonics[m]) * field_->w[m];
            known->second = domain.graph().inverse(domain.leaf_polynomial(divisor));
        }
        return known->second;
    }

    const OscillatorField* field_;
    std::map<std::vector<int>, Coefficient> inverses_;
    std::vector<std::pair<OuterKey, Coefficient>> divided_;
};

template <class Division> class Normalizer {
public:
    using Domain = typename Division::Domain;
    using Part = typename Domain::Part;

    Normalizer(const OscillatorField& field, Division& division)
        : field_(field), division_(division), run_(*field.program, division.domain), h(field.z.size()),
          rate(field.z.size()), conjugate_rate_(field.z.size()), by_z_(field.z.size() * field.z.size()),
          by_zbar_(by_z_.size()) {
        const Ring& ring = *field.ring;
        for (const Polynomial& w : field.w)
            factor_.push_back(domain().constant(ring.multiply(-ring.imaginary(), *ring.inverse(w))));
    }

    void advance(int weight) {
        const std::size_t n = field_.z.size();
        for (std::size_t j = 0; j < n; ++j) set_inputs(j, weight);
        run_.advance(weight);
        for (std::size_t j = 0; j < n && weight > 1; ++j) {
            const Part& force = run_.part(field_.force[j], weight);
            const Solved<Part> solved = division_.solve(right_hand_side(j, weight, force), j);
            h[j].set(weight, solved.divided);
            for (std::size_t m = 0; m < n; ++m) {
                by_z_[j * n + m].set(weight - 1, domain().derivative(solved.divided, field_.z[m]));
                by_zbar_[j * n + m].set(weight - 1, domain().derivative(solved.divided, field_.zbar[m]));
            }
            rate[j].set(weight, solved.kept);
        }
        for (std::size_t j = 0; j < n; ++j) {
            conjugate_rate_[j].set(weight, domain().conjugate(rate[j].part(weight)));
            set_inputs(j, weight);
        }
        run_.correct(weight);
    }

    [[nodiscard]] const Domain& domain() const { return division_.domain; }

private:
    Part right_hand_side(std::size_t j, int weight, const Part& force) {
        const std::size_t n = field_.z.size();
        std::vector<ProductOf<Part>> products{{1, &force, &factor_[j]}};
        for (std::size_t m = 0; m < n; ++m)
            for (int a = 1; a < weight; ++a) {
                products.push_back({-1, &by_z_[j * n + m].part(a), &rate[m].part(weight - a)});
                products.push_back({-1, &by_zbar_[j * n + m].part(a), &conjugate_rate_[m].part(weight - a)});
            }
        return domain().dot(products);
    }

    void set_inputs(std::size_t j, int weight) {
        Part z = h[j].part(weight);
        if (weight == 1) z = domain().constant(field_.ring->gen(field_.z[j]));
        run_.set_input(field_.input_conjugate[j], weight, domain().conjugate(z));
        run_.set_input(field_.input[j], weight, std::move(z));
    }

    const OscillatorField& field_;
    Division& division_;
    BasicSeriesRun<Domain> run_;

public:
    std::vector<BasicSeries<Part>> h, rate;

private:
    std::vector<BasicSeries<Part>> conjugate_rate_, by_z_, by_zbar_;
    std::vector<Part> factor_;
};

} // namespace resonform::testing
