// SPDX-License-Identifier: GPL-3.0-or-later
// A second, small normaliser for systems of oscillators with polynomial potentials: what the graph's tests
// and its benchmark derive. Over any domain of coefficients, fast equations only.
//
//   q_j'' + w_j^2 q_j + dV/dq_j = 0,   V = sum of all cubic and quartic monomials, random rational couplings,
//   z_j = q_j - i q_j'/w_j,            z_j' = i w_j z_j - (i/w_j) dV/dq_j  (+ the frame's turn if w_j is
//   slow)
#pragma once

#include "algebra/graph/domain.hpp"
#include "algebra/series/series_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace resonform::testing {

struct Oscillators {
    int n;
    bool cubic = true, quartic = true;
    int symbolic = 0; // as many couplings are parameters; the rest are numbers
    std::uint64_t seed = 5;
};

// The program of all dV/dq_j as functions of the z, in Horner's form: q_a (sum_b c q_b + sum_bc d q_b q_c).
struct OscillatorField {
    RingPtr ring;
    std::vector<GeneratorId> z, zbar;
    std::vector<Polynomial> w; // frequencies
    std::vector<SeriesProgram::Node> input, input_conjugate, force;
    std::shared_ptr<SeriesProgram> program;
};

class OscillatorBuilder {
public:
    // numbers: frequencies (symbols where it is empty)
    explicit OscillatorBuilder(const Oscillators& system, const std::vector<Rational>& numbers = {})
        : system_(system), random_(system.seed) {
        RingBuilder builder;
        const auto add = [&](GeneratorKind kind, const std::string& name, GeneratorId conjugate = -1) {
            Generator g;
            g.kind = kind;
            g.name = name;
            g.weight = kind == GeneratorKind::parameter ? 0 : 1;
            g.conjugate = conjugate;
            g.invertible = g.positive = kind == GeneratorKind::parameter;
            return builder.add(g);
        };
        for (int k = 0; k < system.n; ++k) {
            const GeneratorId first = builder.next();
            field_.z.push_back(add(GeneratorKind::fast, fmt::format("z{}", 2 * k + 1), first + 1));
            field_.zbar.push_back(add(GeneratorKind::fast, fmt::format("z{}", 2 * k + 2), first));
        }
        std::vector<GeneratorId> frequencies, couplings;
        for (int k = 0; k < system.n && numbers.empty(); ++k)
            frequencies.push_back(add(GeneratorKind::parameter, fmt::format("w{}", k + 1)));
        for (int k = 0; k < system.symbolic; ++k)
            couplings.push_back(add(GeneratorKind::parameter, fmt::format("c{}", k + 1)));
        field_.ring = builder.freeze();
        for (int k = 0; k < system.n; ++k)
            field_.w.push_back(numbers.empty() ? field_.ring->gen(frequencies[static_cast<std::size_t>(k)])
                                               : Polynomial(numbers[static_cast<std::size_t>(k)]));
        for (const GeneratorId id : couplings) couplings_.push_back(field_.ring->gen(id));
    }

    OscillatorField build() {
        field_.program = std::make_shared<SeriesProgram>(field_.ring);
        SeriesProgram& program = *field_.program;
        std::vector<SeriesProgram::Node> q;
        const Rational half = Rational(1) / 2;
        for (int k = 0; k < system_.n; ++k) {
            field_.input.push_back(program.input("z"));
            field_.input_conjugate.push_back(program.input("zbar"));
            q.push_back(program.sum({{half, field_.input.back()}, {half, field_.input_conjugate.back()}}));
        }
        for (int j = 0; j < system_.n; ++j) field_.force.push_back(force(j, q));
        return field_;
    }

private:
    // Of the monomial q_a q_b (q_c) in the potential; c = -1: cubic terms have one index less.
    SeriesProgram::Node times_coupling(std::vector<int> indices, SeriesProgram::Node node, int multiplicity) {
        std::sort(indices.begin(), indices.end());
        const auto [known, fresh] = chosen_.emplace(indices, Polynomial());
        if (fresh) {
            const Rational number =
                Rational(static_cast<int>(random_() % 17U) + 1) / (static_cast<int>(random_() % 7U) + 2);
            known->second = next_ < couplings_.size() ? couplings_[next_++] : Polynomial(number);
        }
        SeriesProgram& program = *field_.program;
        const Polynomial c = Rational(multiplicity) * known->second;
        if (c.size() == 1 && c.terms().front().monomial == Monomial{})
            return program.sum({{c.terms().front().coefficient, node}});
        return program.product(program.constant(c), node);
    }

    // d/dq_j of sum over sorted monomials = sum over a <= ... of (multiplicity of j) c q_a ...
    SeriesProgram::Node force(int j, const std::vector<SeriesProgram::Node>& q) {
        SeriesProgram& program = *field_.program;
        const auto at = [](int k) { return static_cast<std::size_t>(k); };
        std::vector<std::pair<Rational, SeriesProgram::Node>> total;
        for (int a = 0; a < system_.n; ++a) {
            std::vector<std::pair<Rational, SeriesProgram::Node>> inner;
            for (int b = a; b < system_.n; ++b) {
                if (system_.cubic)
                    inner.emplace_back(1, times_coupling({j, a, b}, q[at(b)], count({j, a, b}, j)));
                for (int c = b; c < system_.n && system_.quartic; ++c)
                    inner.emplace_back(1, times_coupling({j, a, b, c}, program.product(q[at(b)], q[at(c)]),
                                                         count({j, a, b, c}, j)));
            }
            total.emplace_back(1, program.product(q[at(a)], program.sum(inner)));
        }
        return program.sum(total);
    }

    static int count(const std::vector<int>& indices, int j) {
        return static_cast<int>(std::count(indices.begin(), indices.end(), j));
    }

    Oscillators system_;
    std::mt19937_64 random_;
    OscillatorField field_;
    std::vector<Polynomial> couplings_;
    std::size_t next_ = 0;
    std::map<std::vector<int>, Polynomial> chosen_;
};

} // namespace resonform::testing
