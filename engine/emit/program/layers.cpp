// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/layers.hpp"

#include "emit/display/quantity.hpp"
#include "emit/graph/conditioning.hpp"
#include "emit/program/prune.hpp"
#include "solve/flow/slow_flow.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

// |D|^2 from D: multiplied out it would lose twice the digits that D loses.
Graph::Node square_of(Graph& graph, const Ring& ring, const Polynomial& divisor, const ToNode& lower) {
    const auto [re, im] = real_and_imaginary(ring, divisor, lower);
    return graph.add({graph.power(re, 2), graph.power(im, 2)});
}

// |D|^2 -+ both parts of dD/dt, without those that are known to be positive.
std::vector<Graph::Node> margins_of(Graph& graph, const Ring& ring, const MovingDivisor& moving,
                                    const Surroundings& surroundings, Graph::Node square,
                                    const ToNode& lower) {
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

// D^2 + rho^2
Graph::Node raised_square(Graph& graph, Graph::Node now, Graph::Node start) {
    const Graph::Node least = graph.rational(cln::expt(Rational(2), -180));
    return graph.add({graph.power(now, 2), graph.multiply({least, graph.power(start, 2)})});
}

// eps^{2(N + 1)} |D|^{2(p + 1)} - 10^6 e^{2 chi} |D_0|^{2(p + 1)}
Graph::Node gone(Program& program, int order, int power, Graph::Node square, Graph::Node square_at_start,
                 const std::vector<int>& product, std::size_t first_decay) {
    Graph& graph = program.graph;
    std::vector<Graph::Node> left{graph.rational(-1'000'000), graph.power(square_at_start, power + 1)};
    for (std::size_t k = 0; k < product.size(); ++k)
        if (product[k] != 0)
            left.push_back(graph.power(program.phases[first_decay + k].exponential, 2 * product[k]));
    return graph.add(
        {graph.multiply({graph.power(program.small, 2 * (order + 1)), graph.power(square, power + 1)}),
         graph.multiply(left)});
}

} // namespace

std::pair<Graph::Node, Graph::Node> real_and_imaginary(const Ring& ring, const Polynomial& p,
                                                       const ToNode& lower) {
    const Polynomial turned_back = -Polynomial(ring.monomial(Ring::imaginary_unit), 1); // 1/i
    const Polynomial conjugate = ring.conjugate(p);
    return {lower(Rational(1) / 2 * (p + conjugate)),
            lower(ring.multiply(turned_back, Rational(1) / 2 * (p - conjugate)))};
}

void add_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                const ToNode& lower, const ToNode& divisor) {
    Graph& graph = program.graph;
    const Ring& ring = *normalization.normal_form.field->ring;
    const auto square = [&](const Polynomial& d) { return square_of(graph, ring, d, divisor); };
    for (const MovingDivisor& moving : moving_divisors(normalization)) {
        for (const Graph::Node margin :
             margins_of(graph, ring, moving, surroundings, square(moving.divisor), lower))
            if (varies(program, margin)) program.layers.push_back({margin, quantity(ring, moving.divisor)});
    }
    const Graph::Node largest =
        graph.rational(least_divisor() * least_divisor() / 4); // (10^-4 eps)^2 at eps = 1/2
    for (const StandingDivisor& standing : standing_divisors(normalization)) {
        const Graph::Node rest = graph.add({lower(standing.square), graph.negate(largest)});
        if (signs_of(graph, rest, surroundings.positive).is_positive()) continue;
        const Graph::Node exact = square(standing.divisor);
        const bool rewritten = exact != square_of(graph, ring, standing.divisor, lower);
        const Graph::Node margin = rewritten ? graph.add({exact, graph.negate(lower(standing.least))})
                                             : lower(standing.square - standing.least);
        program.positive.push_back({margin, quantity(ring, standing.divisor)});
    }
}

void add_start_layers(Program& program, const Normalization& normalization, const Surroundings& surroundings,
                      const ToNode& lower) {
    const Ring& ring = *normalization.normal_form.field->ring;
    for (const MovingDivisor& moving : moving_divisors_at_start(normalization))
        for (const Graph::Node margin :
             margins_of(program.graph, ring, moving, surroundings,
                        square_of(program.graph, ring, moving.divisor, lower), lower))
            program.positive.push_back({margin, quantity(ring, moving.divisor)});
}

Graph::Node inverse_of(Graph& graph, Graph::Node now, Graph::Node start) {
    return graph.multiply({now, graph.power(raised_square(graph, now, start), -1)});
}

void add_fading(Program& program, const Solution& solution, const Surroundings& surroundings,
                const FadingDivisor& fading, const ToNode& start, const ToNode& now) {
    Graph& graph = program.graph;
    const Ring& ring = *solution.normalization->normal_form.field->ring;
    const Polynomial& divisor = fading.moving.divisor; // real, as a radicand is
    const Graph::Node moves = now(divisor), begins = start(divisor);
    std::vector<Graph::Node> clear =
        margins_of(graph, ring, fading.moving, surroundings, square_of(graph, ring, divisor, now), now);
    clear.push_back(graph.multiply({begins, moves}));
    const std::size_t first_decay = solution.flow->phases.size();
    for (const std::vector<int>& product : fading.products) {
        const auto decay = static_cast<std::size_t>(
            std::find_if(product.begin(), product.end(), [](int times) { return times != 0; }) -
            product.begin());
        const Graph::Node harmless =
            gone(program, solution.order, fading.power, raised_square(graph, moves, begins),
                 graph.power(begins, 2), product, first_decay);
        for (const Graph::Node margin : clear)
            program.phases[first_decay + decay].precision.push_back({margin, harmless});
    }
}

} // namespace resonform
