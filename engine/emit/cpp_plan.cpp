// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp_plan.hpp"

#include "emit/cpp_names.hpp"
#include "emit/prune.hpp"

#include <algorithm>
#include <set>

namespace resonform {

using Value = StraightLine::Value;

CppPlan::CppPlan(const Program& p) : program(&p), code(p) {
    name_inputs();
    assign_levels();
    lower_results();
    find_members();
}

void CppPlan::name_inputs() {
    const auto unique = [](const std::vector<ProgramInput>& inputs) {
        CppNames names;
        std::vector<std::string> result;
        result.reserve(inputs.size());
        for (const ProgramInput& input : inputs) result.push_back(names.unique(input.name));
        return result;
    };
    parameters = unique(program->parameters);
    start = unique(program->start);
}

void CppPlan::assign_levels() {
    if (!program->flow.empty()) {
        levels.push_back({true, {}});
        for (std::size_t k = 0; k < program->flow.size(); ++k) levels.back().members.push_back(k);
    }
    const std::size_t first = levels.size();
    std::vector<std::size_t> level(program->tables.size(), first);
    for (std::size_t k = 0; k < level.size(); ++k) {
        const std::vector<bool> used = reachable(program->graph, {program->tables[k].integrand});
        for (std::size_t j = 0; j < k; ++j)
            if (used[static_cast<std::size_t>(program->tables[j].value)])
                level[k] = std::max(level[k], level[j] + 1);
        if (levels.size() <= level[k]) levels.resize(level[k] + 1);
        levels[level[k]].members.push_back(k);
    }
}

std::vector<CppPlan::Column> CppPlan::columns() const {
    std::vector<Column> list;
    for (const CppLevel& level : levels)
        for (const std::size_t k : level.members)
            list.push_back(level.flow ? Column{program->flow[k].name, program->flow[k].value}
                                      : Column{program->tables[k].name, program->tables[k].value});
    return list;
}

std::size_t CppPlan::columns_before(std::size_t level) const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < level; ++k) count += levels[k].members.size();
    return count;
}

void CppPlan::lower_results() {
    const auto results = [this](const std::vector<ProgramOutput>& list) {
        CppNames names;
        std::vector<CppResult> lowered;
        lowered.reserve(list.size());
        for (const ProgramOutput& output : list)
            lowered.push_back({names.unique(output.name), code.lower(output.value)});
        return lowered;
    };
    CppNames names;
    for (const ProgramFlow& variable : program->flow) {
        flow_starts.push_back(code.lower(variable.start));
        flow_rates.push_back(code.lower(variable.rate));
    }
    const std::vector<Column> looked_up = columns();
    integrands.reserve(program->tables.size());
    for (const ProgramTable& table : program->tables) integrands.push_back(code.lower(table.integrand));
    for (const ProgramPhase& phase : program->phases) {
        phase_names.push_back(names.unique(phase.name));
        phase_starts.push_back(code.lower(phase.start));
        phase_rates.push_back(code.lower(phase.rate));
        const std::vector<bool> used = reachable(program->graph, {phase.rate});
        phase_uses_tables.push_back(
            std::any_of(looked_up.begin(), looked_up.end(),
                        [&](const Column& column) { return used[static_cast<std::size_t>(column.value)]; }));
    }
    outputs = results(program->outputs);
    state = results(program->state);
    for (const Graph::Node condition : program->positive) {
        const Value v = code.lower(condition);
        (code.at(v).varying ? varying_conditions : constant_conditions).push_back(v);
    }
    const std::vector<bool> behind_layers = reachable(program->graph, program->layers);
    for (const Graph::Node margin : program->layers) layers.push_back(code.lower(margin));
    for (const ProgramFlow& variable : program->flow)
        layers_use_flow = layers_use_flow || behind_layers[static_cast<std::size_t>(variable.value)];
}

// Constants that varying values use, and results that are constant; small integers are written in place.
void CppPlan::find_members() {
    std::vector<Value> roots = integrands;
    for (const std::vector<Value>* more : {&flow_starts, &flow_rates, &phase_starts, &phase_rates,
                                           &constant_conditions, &varying_conditions, &layers})
        roots.insert(roots.end(), more->begin(), more->end());
    for (const std::vector<CppResult>* results : {&outputs, &state})
        for (const CppResult& result : *results) roots.push_back(result.value);

    std::map<Graph::Node, std::string> inputs{{program->eps, "eps"}};
    for (const std::vector<ProgramInput>* list : {&program->parameters, &program->start})
        for (const ProgramInput& input : *list) inputs[input.symbol] = input.name;

    std::set<Value> kept(phase_starts.begin(), phase_starts.end()); // whatever they are
    kept.insert(flow_starts.begin(), flow_starts.end());
    kept.insert(constant_conditions.begin(), constant_conditions.end());
    CppNames names;
    for (const Value v : code.behind(roots, false)) {
        const StraightLine::Instruction& i = code.at(v);
        const bool literal = i.op == StraightLine::Op::number && cln::denominator(i.number) == 1 &&
                             cln::abs(i.number) < (Integer(1) << 31) && kept.count(v) == 0;
        if (i.varying || literal) continue;
        const std::string wish = i.op == StraightLine::Op::symbol ? inputs.at(i.symbol) : i.label;
        members[v] = wish.empty() ? names.numbered("c") : names.unique(wish);
    }
}

} // namespace resonform
