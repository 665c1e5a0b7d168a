// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/layers.hpp"

#include "emit/display/quantity.hpp"
#include "emit/graph/conditioning.hpp"
#include "emit/program/prune.hpp"
#include "solve/flow/slow_flow.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace resonform {

namespace {

const Rational least_divisor = Rational(1) / 10'000; // |D| > 10^-4 eps

// One divisor of each kind D = factor * primitive, the one with the smallest factor > 0.
enum class Of { all, lasting, transient };
std::vector<Polynomial> smallest_of_each(const Normalization& normalization, Of which) {
    std::vector<std::pair<Polynomial, Rational>> known; // primitive, factor
    for (const DivisorRecord& record : normalization.divisors) {
        if (record.verdict != DivisorVerdict::removed) continue;
        const bool transient = has_damped_mode(*normalization.normal_form.field, record.monomial);
        if (which != Of::all && transient != (which == Of::transient)) continue;
        const Rational lead = record.divisor.terms().front().coefficient, factor = cln::abs(lead);
        const Polynomial primitive = (1 / lead) * record.divisor;
        const auto same = std::find_if(known.begin(), known.end(),
                                       [&](const auto& entry) { return entry.first == primitive; });
        if (same == known.end())
            known.emplace_back(primitive, factor);
        else
            same->second = std::min(same->second, factor);
    }
    std::vector<Polynomial> divisors;
    for (const auto& [primitive, factor] : known) divisors.push_back(factor * primitive);
    return divisors;
}

// dD/dt by the leading part of each slow rate; nullopt: it is not known.
std::optional<Polynomial> rate_of(const Polynomial& divisor, const NormalForm& normal_form) {
    const GradedField& field = *normal_form.field;
    const Ring& ring = *field.ring;
    std::vector<Polynomial> addends;
    for (std::size_t k = 0; k < field.slow.size(); ++k) {
        if (!ring.derivative_known(divisor, field.slow[k].generator)) return std::nullopt;
        const Series& rate = normal_form.slow[k];
        int weight = 0;
        while (weight < rate.through() && rate.part(weight).empty()) ++weight;
        addends.push_back(
            ring.multiply(ring.derivative(divisor, field.slow[k].generator), rate.part(weight)));
    }
    return sum(addends);
}

std::vector<MovingDivisor> moving_of(const Normalization& normalization, Of which) {
    std::vector<MovingDivisor> moving;
    for (const Polynomial& divisor : smallest_of_each(normalization, which)) {
        const std::optional<Polynomial> rate = rate_of(divisor, normalization.normal_form);
        if (rate && !rate->empty()) moving.push_back({divisor, *rate});
    }
    return moving;
}

} // namespace

std::pair<Graph::Node, Graph::Node>
real_and_imaginary(const Ring& ring, const Polynomial& p,
                   const std::function<Graph::Node(const Polynomial&)>& lower) {
    const Polynomial turned_back = -Polynomial(ring.monomial(Ring::imaginary_unit), 1); // 1/i
    const Polynomial conjugate = ring.conjugate(p);
    return {lower(Rational(1) / 2 * (p + conjugate)),
            lower(ring.multiply(turned_back, Rational(1) / 2 * (p - conjugate)))};
}

std::vector<Graph::Node> margins_of(Graph& graph, const Ring& ring, const MovingDivisor& moving,
                                    const Surroundings& surroundings,
                                    const std::function<Graph::Node(const Polynomial&)>& lower) {
    const auto [re, im] = real_and_imaginary(ring, moving.divisor, lower);
    const Graph::Node square = graph.add({graph.power(re, 2), graph.power(im, 2)});
    const auto [re_rate, im_rate] = real_and_imaginary(ring, moving.rate, lower);
    std::vector<Graph::Node> margins;
    for (const Graph::Node component : {re_rate, im_rate})
        for (const Graph::Node change : {component, graph.negate(component)}) {
            const Graph::Node margin = graph.add({square, change});
            if (margin != square && !signs_of(graph, margin, surroundings.positive).is_positive())
                margins.push_back(margin);
        }
    return margins;
}

std::vector<MovingDivisor> moving_divisors(const Normalization& normalization) {
    return moving_of(normalization, Of::lasting);
}

std::vector<MovingDivisor> moving_divisors_at_start(const Normalization& normalization) {
    return moving_of(normalization, Of::transient);
}

std::vector<StandingDivisor> standing_divisors(const Normalization& normalization) {
    const GradedField& field = *normalization.normal_form.field;
    const Ring& ring = *field.ring;
    const Polynomial eps = ring.gen(field.eps, ring.weights_in_one());
    const Polynomial floor = (least_divisor * least_divisor) * ring.multiply(eps, eps);
    std::vector<StandingDivisor> standing;
    for (const Polynomial& divisor : smallest_of_each(normalization, Of::all)) {
        const std::optional<Polynomial> rate = rate_of(divisor, normalization.normal_form);
        if (rate && rate->empty())
            standing.push_back({divisor, ring.multiply(divisor, ring.conjugate(divisor)) - floor});
    }
    return standing;
}

void add_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                const std::function<Graph::Node(const Polynomial&)>& lower) {
    Graph& graph = program.graph;
    const Ring& ring = *normalization.normal_form.field->ring;
    for (const MovingDivisor& moving : moving_divisors(normalization)) {
        for (const Graph::Node margin : margins_of(graph, ring, moving, surroundings, lower))
            if (varies(program, margin)) program.layers.push_back({margin, quantity(ring, moving.divisor)});
    }
    const Graph::Node largest =
        graph.rational(least_divisor * least_divisor / 4); // (10^-4 eps)^2 at eps = 1/2
    for (const StandingDivisor& standing : standing_divisors(normalization)) {
        const Graph::Node square = lower(ring.multiply(standing.divisor, ring.conjugate(standing.divisor)));
        const Graph::Node rest = graph.add({square, graph.negate(largest)});
        if (!signs_of(graph, rest, surroundings.positive).is_positive())
            program.positive.push_back({lower(standing.margin), quantity(ring, standing.divisor)});
    }
}

void add_start_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                      const std::function<Graph::Node(const Polynomial&)>& lower) {
    const Ring& ring = *normalization.normal_form.field->ring;
    for (const MovingDivisor& moving : moving_divisors_at_start(normalization))
        for (const Graph::Node margin : margins_of(program.graph, ring, moving, surroundings, lower))
            program.positive.push_back({margin, quantity(ring, moving.divisor)});
}

} // namespace resonform
