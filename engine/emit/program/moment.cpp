// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/moment.hpp"

#include "emit/display/quantity.hpp"
#include "emit/graph/conditioning.hpp"
#include "emit/graph/from_expression.hpp"
#include "emit/graph/function_domain.hpp"
#include "emit/program/prune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace resonform {

namespace {

// Names for a radicand and its roots: s = xi^2 + r^2, s_2 = s^(1/2), s_4, s_8; then s1, s1_2, ... A
// radicand that has a name keeps it: tau, tau_2.
void name_roots(Program& program, Graph::Node n, int& radicands) {
    std::vector<Graph::Node> nested;
    for (; program.graph.at(n).op == Graph::Op::root; n = program.graph.at(n).operands.front())
        nested.push_back(n);
    const auto known = std::find_if(program.names.begin(), program.names.end(),
                                    [&](const ProgramOutput& named) { return named.value == n; });
    std::string name = radicands == 0 ? "s" : fmt::format("s{}", radicands);
    if (known == program.names.end())
        ++radicands;
    else
        name = known->name;
    program.names.push_back({name, n});
    int index = 1;
    for (auto root = nested.rbegin(); root != nested.rend(); ++root) {
        index *= program.graph.at(*root).exponent;
        program.names.push_back({fmt::format("{}_{}", name, index), *root});
    }
}

bool contains_varying(const Lowering& lowering, const Polynomial& p) {
    const Ring& ring = lowering.ring();
    return std::any_of(p.terms().begin(), p.terms().end(), [&](const Term& t) {
        for (GeneratorId id = 0; id < ring.size(); ++id)
            if (ring.exponent(t.monomial, id) != 0 && lowering.varying(id)) return true;
        return false;
    });
}

// The declared sign of a callable is seen only when it is called.
void define_named(Lowering& lowering, Program& program, const Surroundings& surroundings, GeneratorId id) {
    const FunctionOf& of = lowering.ring().generator(id).of;
    const Graph::Node value =
        named_node(program.graph, surroundings, of.symbol, of.derivative, lowering.radicand(of.argument));
    if (const auto callable = surroundings.callables.find(of.symbol);
        callable != surroundings.callables.end() && callable->second && of.derivative == 0)
        program.positive.push_back({value, quantity(lowering.ring(), lowering.ring().gen(id))});
    lowering.define(id, value, contains_varying(lowering, of.argument));
}

void define_function(Lowering& lowering, Program& program, const Surroundings& surroundings, GeneratorId id) {
    const Ring& ring = lowering.ring();
    const FunctionOf& of = ring.generator(id).of;
    if (of.function == Function::named) {
        define_named(lowering, program, surroundings, id);
        return;
    }
    if (const std::optional<Polynomial> positive = positive_for(ring, of)) {
        const Graph::Node margin = lowering.radicand(*positive);
        if (!signs_of(program.graph, margin, surroundings.positive).is_positive())
            program.positive.push_back({margin, quantity(ring, *positive)});
    }
    const Graph::Node argument = lowering.radicand(of.argument);
    lowering.define(id, function_node(program.graph, of.function, argument),
                    contains_varying(lowering, of.argument));
}

} // namespace

Graph::Node named_node(Graph& graph, const Surroundings& surroundings, const std::string& name,
                       int derivative, Graph::Node x) {
    if (surroundings.callables.count(name) != 0) return graph.callable(name, derivative, x);
    return graph.spline(surroundings.data.at(name), derivative, x);
}

void define_roots_and_functions(Lowering& lowering, Program& program, const Surroundings& surroundings,
                                bool named) {
    int radicands = 0;
    const Ring& ring = lowering.ring();
    lowering.set_positive(surroundings.positive);
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.kind == GeneratorKind::function) define_function(lowering, program, surroundings, id);
        if (g.kind != GeneratorKind::root) continue;
        const bool divisor = g.index == 1 && !g.positive;
        const Graph::Node radicand = lowering.conditioned(g.radicand);
        if (!divisor && !signs_of(program.graph, radicand, surroundings.positive).is_positive())
            program.positive.push_back({radicand, quantity(ring, g.radicand)});
        const Graph::Node root = g.index == 1 ? radicand : program.graph.root(radicand, g.index);
        const bool varies = contains_varying(lowering, g.radicand);
        lowering.define(id, root, varies);
        if (varies && named) name_roots(program, root, radicands);
    }
}

Moment::Moment(Program& program, const Solution& solution, RingPtr ring, const Surroundings& surroundings,
               const MomentPlan& plan)
    : lowering(program.graph, ring), harmonics(program.graph, ring, lowering), ring_(std::move(ring)) {
    for (GeneratorId id = 0; id < ring_->size(); ++id)
        if (const auto known = surroundings.symbols.find(ring_->generator(id).name);
            known != surroundings.symbols.end())
            define(program, id, known->second);
    for (const auto& [id, node] : plan.slow_variables) define(program, own(id, solution), node);
    if (solution.slow_time) define(program, own(*solution.slow_time, solution), plan.slow_time);
    define_roots_and_functions(lowering, program, surroundings, true);
    define_primitives(program, solution, surroundings, plan);
}

GeneratorId Moment::own(GeneratorId id, const Solution& solution) const {
    return *ring_->find(solution.ring->generator(id).name);
}

void Moment::define(const Program& program, GeneratorId id, Graph::Node node) {
    lowering.define(id, node,
                    depending(program.graph, varying_symbols(program))[static_cast<std::size_t>(node)]);
}

void Moment::define_primitives(Program& program, const Solution& solution, const Surroundings& surroundings,
                               const MomentPlan& plan) {
    const RingMap map = RingMap::by_name(solution.ring, ring_);
    for (const Primitive& primitive : solution.primitives) {
        Graph::Node node = -1;
        switch (primitive.kind) {
        case PrimitiveKind::quadrature: node = plan.quadrature(primitive, lowering); break;
        case PrimitiveKind::exponential:
            node = program.graph.function(Graph::Op::exp, {lowering.polynomial(map(primitive.argument))});
            break;
        case PrimitiveKind::logarithm:
            node = lower_logarithm(program.graph, *ring_, lowering, map(primitive.argument),
                                   surroundings.positive);
            if (const Graph::Entry& e = program.graph.at(node);
                e.op == Graph::Op::log &&
                !signs_of(program.graph, e.operands.front(), surroundings.positive).is_positive())
                program.positive.push_back({e.operands.front(), quantity(*ring_, map(primitive.argument))});
            break;
        }
        define(program, own(primitive.id, solution), node);
    }
}

} // namespace resonform
