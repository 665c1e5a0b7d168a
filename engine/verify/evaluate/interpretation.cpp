// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluate/interpretation.hpp"

#include "emit/program/prune.hpp"

namespace resonform {

namespace {

// Some results, the conditions, and what tells how precise phases are.
std::vector<Graph::Node> at_call(const Program& program, const std::vector<ProgramOutput>& results) {
    std::vector<Graph::Node> roots = values_of(results);
    for (const ProgramCondition& condition : program.positive) roots.push_back(condition.value);
    for (const ProgramPhase& phase : program.phases)
        for (const std::vector<Graph::Node>& either : phase.precision)
            roots.insert(roots.end(), either.begin(), either.end());
    return roots;
}

} // namespace

Interpretation::Interpretation(std::shared_ptr<const Program> p)
    : program(std::move(p)), plan(*program), changes(depending(program->graph, varying_symbols(*program))),
      outputs_at_call(NodesBehind(*this, at_call(*program, program->outputs)).varying),
      state_at_call(NodesBehind(*this, at_call(*program, program->state)).varying),
      conditions(plan.conditions_text()), results(plan.results_text()) {
    for (std::size_t n = 0; n < program->graph.size(); ++n) {
        const Graph::Entry& e = program->graph.at(static_cast<Graph::Node>(n));
        numbers.push_back(e.op == Graph::Op::rational ? binary_parts(e.value) : BinaryParts{});
    }
    for (std::size_t v = 0; v < plan.code.size(); ++v) {
        const StraightLine::Instruction& i = plan.code.at(static_cast<StraightLine::Value>(v));
        plan_numbers.push_back(i.op == StraightLine::Op::number ? binary_parts(i.number) : BinaryParts{});
    }
}

NodesBehind::NodesBehind(const Interpretation& shared, const std::vector<Graph::Node>& roots) {
    const std::vector<bool> used = reachable(shared.program->graph, roots);
    for (std::size_t n = 0; n < used.size(); ++n)
        if (used[n]) (shared.changes[n] ? varying : constant).push_back(static_cast<Graph::Node>(n));
}

std::vector<Graph::Node> values_of(const std::vector<ProgramOutput>& results) {
    std::vector<Graph::Node> nodes;
    for (const ProgramOutput& result : results) nodes.push_back(result.value);
    return nodes;
}

} // namespace resonform
