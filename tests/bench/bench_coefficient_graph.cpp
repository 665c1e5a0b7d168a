// SPDX-License-Identifier: GPL-3.0-or-later
// bench_coefficient_graph [derive | couplings | slow | expand | replay]...: the graph of coefficients on
// oscillators with symbolic frequencies and all cubic and quartic terms of the potential, their couplings
// random numbers.
//
// Times are the least of several runs; nodes, terms and memory are of the largest order shown. "certificate"
// is the substitution of map and normal form into the equations, evaluated at fresh points modulo fresh
// primes.
#include "algebra/graph/bounds.hpp"
#include "algebra/graph/expansion.hpp"
#include "algebra/normalizer.hpp"
#include "bench/measure.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

using namespace resonform;
using bench::least_seconds;
using bench::peak_megabytes;
using bench::seconds_since;
using testing::GraphDivision;
using testing::OscillatorBuilder;
using testing::OscillatorField;
using testing::Oscillators;
using Normalizer = testing::Normalizer<GraphDivision>;

struct Derivation {
    OscillatorField field;
    GraphDivision division;
    Normalizer normalizer;

    Derivation(const Oscillators& system, int order)
        : field(OscillatorBuilder(system).build()), division(field, order + 1), normalizer(field, division) {
        for (int weight = 0; weight <= order; ++weight) normalizer.advance(weight);
    }
    [[nodiscard]] CoefficientGraph& graph() const { return division.domain.graph(); }
};

void derive() {
    fmt::print("\n| oscillators | order | nodes | terms | merged | zeros | time s | peak MB | probability of "
               "an error |\n"
               "|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& [n, order] :
         {std::pair{2, 3}, {2, 5}, {2, 7}, {2, 9}, {3, 3}, {3, 5}, {3, 7}, {4, 5}, {4, 7}}) {
        const double time = least_seconds([n = n, order = order] { Derivation({n}, order); });
        const Derivation d({n}, order);
        const CoefficientGraph::Decisions& decisions = d.graph().decisions();
        fmt::print("| {} | {} | {} | {} | {} | {} | {:.4f} | {:.0f} | {:.0e} |\n", n, order, d.graph().size(),
                   d.graph().terms(), decisions.merged, decisions.zeros, time, peak_megabytes(),
                   bounds_of(d.graph()).error_probability);
        std::fflush(stdout);
    }
}

void couplings() {
    fmt::print("\n| oscillators | order | symbolic couplings | nodes | time s |\n|---|---|---|---|---|\n");
    for (const int symbolic : {0, 5, 20}) {
        const double time = least_seconds([&] { Derivation({3, true, true, symbolic}, 7); });
        fmt::print("| 3 | 7 | {} | {} | {:.4f} |\n", symbolic,
                   Derivation({3, true, true, symbolic}, 7).graph().size(), time);
    }
}

// The coefficient with the most divisors among those of the highest weight.
void expand_one(int n, int order, bool quartic) {
    const Derivation d({n, true, quartic}, order);
    Coefficient worst;
    std::size_t most = 0;
    for (const auto& h : d.normalizer.h)
        for (const Coefficient c : h.part(order).coefficients) {
            const GraphReplay replay(d.graph(), {c});
            if (replay.terms().size() > most) most = replay.terms().size(), worst = c;
        }
    const auto start = std::chrono::steady_clock::now();
    const ExpandedCoefficient e = expand(d.graph(), worst);
    const double time = seconds_since(start);
    int degree = 0;
    for (const auto& [divisor, times] : e.denominator) degree += times * d.graph().divisor(divisor).degree();
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {}x{} | {:.3f} |\n", n, order,
               quartic ? "V3+V4" : "V3", most, degree, e.denominator.size(), e.numerator.degree(),
               e.numerator.terms().size(), e.points, e.primes, time);
    std::fflush(stdout);
}

void expand_some() {
    fmt::print("\n| oscillators | order | potential | terms of its graph | degree of denominator | divisors "
               "| degree of "
               "numerator | terms | points x primes | time s |\n|---|---|---|---|---|---|---|---|---|---|\n");
    expand_one(2, 5, true);
    expand_one(2, 7, true);
    expand_one(2, 9, true);
    expand_one(3, 5, false);
    expand_one(3, 5, true);
    expand_one(3, 7, false);
    expand_one(3, 7, true);
}

// All coefficients of map and normal form, at 16 points.
void replay() {
    fmt::print("\n| oscillators | order | terms | ns for a term and point |\n|---|---|---|---|\n");
    for (const auto& [n, order] : {std::pair{2, 7}, {3, 5}, {3, 7}}) {
        const Derivation d({n}, order);
        std::vector<Coefficient> wanted;
        for (const auto& h : d.normalizer.h)
            for (int weight = 2; weight <= order; ++weight)
                for (const Coefficient c : h.part(weight).coefficients) wanted.push_back(c);
        const GraphReplay replay(d.graph(), wanted);
        std::mt19937_64 random(3);
        ModularReplay modular(replay, PrimeField(random_prime(random)));
        std::vector<ModularReplay::Block> points(replay.leaves().size());
        for (auto& block : points)
            for (Residue& x : block) x = modular.field().random_unit(random);
        const double time = least_seconds([&] { static_cast<void>(modular.evaluate(points)); });
        fmt::print("| {} | {} | {} | {:.2f} |\n", n, order, replay.terms().size(),
                   1e9 * time / static_cast<double>(replay.terms().size() * ModularReplay::block));
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> asked(argv + 1, argv + argc);
    const auto wanted = [&](const char* part) {
        return asked.empty() || std::find(asked.begin(), asked.end(), part) != asked.end();
    };
    if (wanted("derive")) derive();
    if (wanted("couplings")) couplings();
    if (wanted("replay")) replay();
    if (wanted("expand")) expand_some();
}
