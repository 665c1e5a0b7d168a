// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/planted_change.hpp"

#include "algebra/number/error.hpp"
#include "emit/program/prune.hpp"
#include "normalize/certified.hpp"

#include <fmt/format.h>

#include <cmath>

namespace resonform::test {

namespace {

using Op = Graph::Op;
using Node = Graph::Node;

// f(node) of every node that the program refers to; a node that is not there is -1.
template <class F> void each_node(Program& p, const F& f) {
    for (Node* n : {&p.eps, &p.time, &p.slow_time, &p.slow_time_end}) f(*n);
    for (auto* inputs : {&p.parameters, &p.start})
        for (ProgramInput& input : *inputs)
            for (Node* n : {&input.symbol, &input.default_value}) f(*n);
    for (ProgramFlow& flow : p.flow)
        for (Node* n : {&flow.start, &flow.rate, &flow.value}) f(*n);
    for (ProgramTable& table : p.tables)
        for (Node* n : {&table.integrand, &table.value}) f(*n);
    for (ProgramPhase& phase : p.phases) {
        for (Node* n : {&phase.start, &phase.rate}) f(*n);
        for (Node* n : {&phase.cosine, &phase.sine, &phase.exponential, &phase.growth})
            if (*n >= 0) f(*n);
        for (Node& n : phase.fades_with) f(n);
        for (std::vector<Node>& either : phase.precision)
            for (Node& n : either) f(n);
    }
    for (auto* results : {&p.slow, &p.outputs, &p.state, &p.names})
        for (ProgramOutput& result : *results) f(result.value);
    for (auto* conditions : {&p.positive, &p.layers})
        for (ProgramCondition& condition : *conditions) f(condition.value);
}

// What an evaluator computes: no defaults, no names.
std::vector<Node> computed(const Program& p) {
    std::vector<Node> roots;
    for (const ProgramFlow& flow : p.flow) roots.insert(roots.end(), {flow.start, flow.rate});
    for (const ProgramTable& table : p.tables) roots.push_back(table.integrand);
    for (const ProgramPhase& phase : p.phases) roots.insert(roots.end(), {phase.start, phase.rate});
    for (const ProgramOutput& output : p.outputs) roots.push_back(output.value);
    for (const auto* conditions : {&p.positive, &p.layers})
        for (const ProgramCondition& condition : *conditions) roots.push_back(condition.value);
    return roots;
}

const char* name_of(Op op) {
    switch (op) {
    case Op::rational: return "number";
    case Op::add: return "sum";
    case Op::multiply: return "product";
    case Op::power: return "power";
    case Op::root: return "root";
    case Op::cos: return "cosine";
    case Op::sin: return "sine";
    default: return "function";
    }
}

Node made(Graph& graph, const Graph::Entry& e, const std::vector<Node>& operands) {
    switch (e.op) {
    case Op::rational: return graph.rational(e.value);
    case Op::symbol: return graph.symbol(e.name);
    case Op::add: return graph.add(operands);
    case Op::multiply: return graph.multiply(operands);
    case Op::power: return graph.power(operands.front(), e.exponent);
    case Op::root: return graph.root(operands.front(), e.exponent);
    default: return graph.function(e.op, operands);
    }
}

// 1 + d with |d| anywhere between some last places of double and 1.
Rational factor(Draw& draw) {
    constexpr double finest = 1e-15;
    const auto inverse = Integer(fmt::format("{:.0f}", 1 / draw.log_uniform(finest, 1)).c_str());
    const Rational d = Rational(1) / inverse;
    return draw.chance(2) ? Rational(1 + d) : Rational(1 - d);
}

// The changed node, and what was done to it.
std::pair<Node, std::string> changed(Graph& graph, const Graph::Entry& e, std::vector<Node> operands,
                                     Draw& draw) {
    if (e.op == Op::power || e.op == Op::root) {
        Graph::Entry other = e;
        other.exponent += draw.chance(2) && !(e.op == Op::root && e.exponent == 2) ? -1 : 1;
        return {made(graph, other, operands), fmt::format("exponent {} to {}", e.exponent, other.exponent)};
    }
    if (e.op == Op::cos || e.op == Op::sin) {
        Graph::Entry other = e;
        other.op = e.op == Op::cos ? Op::sin : Op::cos;
        return {made(graph, other, operands), fmt::format("to {}", name_of(other.op))};
    }
    if (e.op == Op::rational) {
        const Rational by = factor(draw);
        return {graph.rational(e.value * by), "times " + to_string(by)};
    }
    const auto k = static_cast<std::size_t>(draw.pick(static_cast<int>(operands.size())));
    std::string what;
    switch (draw.pick(6)) {
    case 0:
        if (e.op == Op::add || e.op == Op::multiply) { // a function needs all it has
            operands.erase(operands.begin() + static_cast<std::ptrdiff_t>(k));
            what = "dropped";
            break;
        }
        [[fallthrough]];
    case 1:
        operands[k] = graph.negate(operands[k]);
        what = "with the other sign";
        break;
    default: {
        const Rational by = factor(draw);
        operands[k] = graph.multiply({graph.rational(by), operands[k]});
        what = "times " + to_string(by);
    }
    }
    return {made(graph, e, operands), fmt::format("operand {} {}", k + 1, what)};
}

// p with the node `target` changed, in a graph of its own.
Planted<Program> with_change(const Program& p, Node target, Draw& draw) {
    Planted<Program> result{p, ""};
    std::vector<Node> roots;
    each_node(result.lie, [&](Node n) {
        if (n >= 0) roots.push_back(n);
    });
    const std::vector<bool> used = reachable(p.graph, roots);
    result.lie.graph = Graph();
    std::vector<Node> to(p.graph.size(), -1);
    for (std::size_t n = 0; n < used.size(); ++n) {
        if (!used[n]) continue;
        const Graph::Entry& e = p.graph.at(static_cast<Node>(n));
        std::vector<Node> operands;
        for (const Node operand : e.operands) operands.push_back(to[static_cast<std::size_t>(operand)]);
        to[n] = made(result.lie.graph, e, operands);
        if (static_cast<Node>(n) != target) continue;
        const Node truth = to[n];
        std::tie(to[n], result.what) = changed(result.lie.graph, e, operands, draw);
        result.what = fmt::format("{} {}: {}", name_of(e.op), n, result.what);
        if (to[n] == truth) result.what.clear();
    }
    each_node(result.lie, [&](Node& n) {
        if (n >= 0) n = to[static_cast<std::size_t>(n)];
    });
    return result;
}

} // namespace

std::optional<Planted<Program>> plant_in_program(const Program& program, Draw& draw) {
    const std::vector<bool> used = reachable(program.graph, computed(program));
    std::vector<Node> candidates;
    for (std::size_t n = 0; n < used.size(); ++n)
        if (used[n] && program.graph.at(static_cast<Node>(n)).op != Op::symbol)
            candidates.push_back(static_cast<Node>(n));
    if (candidates.empty()) return std::nullopt;
    const Node target = draw.any(candidates);
    try {
        Planted<Program> planted = with_change(program, target, draw);
        if (planted.what.empty()) return std::nullopt;
        return planted;
    } catch (const Error&) { // a division by zero, a root of a negative number
        return std::nullopt;
    }
}

std::optional<Planted<Normalization>> plant_in_normal_form(const Normalization& truth, Draw& draw) {
    Planted<Normalization> result{truth, ""};
    struct Place {
        Series* series;
        std::string name;
        int weight;
        std::size_t term;
    };
    std::vector<Place> places;
    for (const SeriesOfForm& item : all_series(result.lie))
        for (int weight = 0; weight <= item.series->through(); ++weight)
            for (std::size_t k = 0; k < item.series->part(weight).size(); ++k)
                places.push_back({item.series, item.name, weight, k});
    if (places.empty()) return std::nullopt;
    const Place& place = draw.any(places);
    std::vector<Term> terms = place.series->part(place.weight).terms();
    const Rational by = factor(draw);
    terms[place.term].coefficient = terms[place.term].coefficient * by;
    place.series->set(place.weight, Polynomial::from_terms(std::move(terms)));
    result.what = fmt::format("{}, weight {}, term {} times {}", place.name, place.weight, place.term + 1,
                              to_string(by));
    return result;
}

} // namespace resonform::test
