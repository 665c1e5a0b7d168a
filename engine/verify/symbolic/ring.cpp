// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/ring.hpp"

#include "emit/graph/from_expression.hpp"
#include "emit/graph/function_domain.hpp"
#include "model/text/canonical.hpp"
#include "runtime/math.hpp"
#include "verify/evaluate/graph_walk.hpp"

#include <limits>
#include <numeric>

namespace resonform {

Wide SymbolicInputs::start_of(const std::string& canonical) const {
    const auto found = start.find(canonical);
    return found == start.end() ? Wide(0) : found->second;
}

SymbolicInputs SymbolicInputs::blind() const {
    SymbolicInputs result = *this;
    for (const std::string& name : untaken) result.start[name] = std::numeric_limits<Wide>::quiet_NaN();
    return result;
}

namespace {

std::map<std::string, Rational> rational_part(const SymbolicRing::Fix& fix) {
    std::map<std::string, Rational> rational;
    for (const auto& [name, value] : fix)
        if (GiNaC::is_a<GiNaC::numeric>(value) && GiNaC::ex_to<GiNaC::numeric>(value).is_rational())
            rational.emplace(name, to_rational(value));
    return rational;
}

Wide number_of(const GiNaC::ex& value) {
    Graph graph;
    const Graph::Node root = from_expression(graph, value, {});
    std::vector<Graph::Node> nodes(graph.size()); // operands before their users
    std::iota(nodes.begin(), nodes.end(), 0);
    GraphWalk<Wide> walk(graph);
    walk.compute(nodes);
    return walk[root];
}

} // namespace

SymbolicRing::SymbolicRing(RingPtr ring, const Fix& fix, const System& system)
    : fix_(fix), fixed_(std::move(ring), rational_part(fix)) {
    const std::map<std::string, Rational> rational = rational_part(fix);
    for (const auto& [name, value] : fix)
        if (rational.count(name) == 0) irrational_.emplace(name, number_of(value));
    for (GeneratorId id = 0; id < this->ring().size(); ++id) {
        const Generator& g = this->ring().generator(id);
        if (g.kind == GeneratorKind::root && !fixed_.is_fixed(id)) {
            const bool divisor = g.index == 1 && !g.positive;
            const SymbolicSum radicand = fixed_(g.radicand);
            roots_.push_back({id, g.index, divisor, radicand, divisor ? SymbolicSum() : radicand});
        }
        if (g.kind != GeneratorKind::function) continue;
        if (g.of.function == Function::named) {
            roots_.push_back({id,
                              1,
                              false,
                              fixed_(g.of.argument),
                              {},
                              g.of.function,
                              system.function(g.of.symbol)->data,
                              g.of.derivative});
            continue;
        }
        const std::optional<Polynomial> positive = positive_for(this->ring(), g.of);
        roots_.push_back({id, 1, false, fixed_(g.of.argument), positive ? fixed_(*positive) : SymbolicSum(),
                          g.of.function});
    }
}

Wide SymbolicRing::small(const SymbolicInputs& inputs) const {
    const int index = ring().weights_in_one();
    return index == 1 ? inputs.eps : math::root(inputs.eps, index);
}

SymbolicValues<Wide> SymbolicRing::constants(const SymbolicInputs& inputs) const {
    SymbolicValues<Wide> values(ring().size());
    values.set(Ring::imaginary_unit, {0, 1}, 1);
    for (GeneratorId id = 0; id < ring().size(); ++id) {
        const Generator& g = ring().generator(id);
        if (g.kind == GeneratorKind::small) values.set(id, small(inputs));
        if (g.kind != GeneratorKind::parameter) continue;
        for (const auto* known : {&inputs.parameters, &irrational_})
            if (const auto given = known->find(g.name); given != known->end()) values.set(id, given->second);
        if (g.name == "pi") values.set(id, math::pi<Wide>());
    }
    return values;
}

bool SymbolicRing::set_roots(SymbolicValues<Wide>& values) const {
    bool defined = true;
    for (const Root& root : roots_) {
        const Wide radicand = value_of(root.radicand, values).re;
        if (!root.positive.empty() && !(value_of(root.positive, values).re > 0)) defined = false;
        set_root(root, radicand, values);
    }
    return defined;
}

} // namespace resonform
