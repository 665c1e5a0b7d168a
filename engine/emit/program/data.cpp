// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/data.hpp"

#include "algebra/number/error.hpp"
#include "emit/program/prune.hpp"

#include <algorithm>

namespace resonform {

namespace {

// Whether a node is a + b T with a and b constant, as far as its form shows it.
bool is_even(const Program& program, const std::vector<bool>& varies, Graph::Node n) {
    const Graph::Entry& e = program.graph.at(n);
    const auto moves = [&](Graph::Node k) { return varies[static_cast<std::size_t>(k)]; };
    if (!moves(n) || n == program.slow_time) return true;
    const auto even = [&](Graph::Node k) { return is_even(program, varies, k); };
    if (e.op == Graph::Op::add) return std::all_of(e.operands.begin(), e.operands.end(), even);
    return e.op == Graph::Op::multiply && std::count_if(e.operands.begin(), e.operands.end(), moves) == 1 &&
           std::all_of(e.operands.begin(), e.operands.end(), even);
}

} // namespace

void find_data(Program& program) {
    std::vector<Graph::Node> roots;
    for (const auto* list : {&program.outputs, &program.state})
        for (const ProgramOutput& output : *list) roots.push_back(output.value);
    for (const ProgramFlow& variable : program.flow) roots.push_back(variable.rate);
    for (const ProgramTable& table : program.tables) roots.push_back(table.integrand);
    for (const ProgramPhase& phase : program.phases) roots.push_back(phase.rate);
    const std::vector<bool> used = reachable(program.graph, roots);
    const std::vector<bool> varies = depending(program.graph, varying_symbols(program));
    program.data.clear();
    for (std::size_t n = 0; n < used.size(); ++n) {
        const Graph::Entry& e = program.graph.at(static_cast<Graph::Node>(n));
        if (!used[n] || e.op != Graph::Op::spline) continue;
        const Graph::Node argument = e.operands.front();
        if (!varies[static_cast<std::size_t>(argument)]) continue;
        const bool known =
            std::any_of(program.data.begin(), program.data.end(), [&](const ProgramData& data) {
                return data.argument == argument && data.samples == e.data;
            });
        if (known) continue;
        if (!is_even(program, varies, argument))
            refuse({"data stand at a slow variable that moves at a constant rate",
                    "the argument of " + e.data->name + " does not",
                    "give " + e.data->name + " as an expression, or take the time itself as its variable",
                    {}});
        program.data.push_back({e.data, argument});
    }
}

} // namespace resonform
