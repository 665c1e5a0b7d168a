// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/prune.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

template <class T, class Needed> void keep(std::vector<T>& items, const Needed& needed) {
    items.erase(std::remove_if(items.begin(), items.end(), [&](const T& item) { return !needed(item); }),
                items.end());
}

// Keeps each needed condition once: conditions of calls may occur at the start, too.
template <class Needed> void keep_first(std::vector<ProgramCondition>& conditions, const Needed& needed) {
    std::set<Graph::Node> seen;
    std::vector<ProgramCondition> kept;
    for (ProgramCondition& c : conditions)
        if (needed(c.value) && seen.insert(c.value).second) kept.push_back(std::move(c));
    conditions = std::move(kept);
}

// Whether all symbols of a condition are used already, so that checking it adds nothing to the program.
bool is_about(const Graph& graph, Graph::Node condition, const std::vector<bool>& used) {
    const std::vector<bool> inside = reachable(graph, {condition});
    for (std::size_t n = 0; n < inside.size(); ++n)
        if (inside[n] && graph.at(static_cast<Graph::Node>(n)).op == Graph::Op::symbol && !used[n])
            return false;
    return true;
}

std::vector<Graph::Node> results(const Program& program) {
    std::vector<Graph::Node> roots;
    for (const ProgramOutput& output : program.outputs) roots.push_back(output.value);
    for (const ProgramOutput& output : program.state) roots.push_back(output.value);
    for (const ProgramRow& row : program.rows) roots.push_back(row.amplitude);
    return roots;
}

bool is_seen(const ProgramPhase& phase, const std::vector<bool>& used) {
    const std::vector<Graph::Node> symbols = phase.symbols();
    return std::any_of(symbols.begin(), symbols.end(),
                       [&](Graph::Node n) { return used[static_cast<std::size_t>(n)]; });
}

// The nodes of the results, and of the tables and phases that they use.
std::vector<bool> needed_nodes(const Program& program) {
    std::vector<Graph::Node> roots = results(program);
    for (std::size_t before = 0; before != roots.size();) {
        before = roots.size();
        const std::vector<bool> used = reachable(program.graph, roots);
        const auto add = [&](Graph::Node n) {
            if (!used[static_cast<std::size_t>(n)]) roots.push_back(n);
        };
        for (const ProgramFlow& variable : program.flow) {
            if (!used[static_cast<std::size_t>(variable.value)]) continue;
            add(variable.start);
            add(variable.rate);
        }
        for (const ProgramTable& table : program.tables)
            if (used[static_cast<std::size_t>(table.value)]) add(table.integrand);
        for (const ProgramPhase& phase : program.phases) {
            if (!is_seen(phase, used)) continue;
            add(phase.start);
            add(phase.rate);
            if (phase.growth >= 0) add(phase.growth);
            for (const std::vector<Graph::Node>& either : phase.precision)
                for (const Graph::Node n : either) add(n);
        }
    }
    return reachable(program.graph, roots);
}

// A row turns with no phase that goes: the outputs would see it.
void keep_phases(Program& program, const std::vector<bool>& used) {
    for (std::size_t p = program.phases.size(); p-- > 0;) {
        if (is_seen(program.phases[p], used)) continue;
        const auto place = static_cast<std::ptrdiff_t>(p);
        program.phases.erase(program.phases.begin() + place);
        for (ProgramRow& row : program.rows) row.turns.erase(row.turns.begin() + place);
    }
    for (ProgramPhase& phase : program.phases)
        std::erase_if(phase.fades_with, [&](Graph::Node n) { return !used[static_cast<std::size_t>(n)]; });
}

} // namespace

std::vector<bool> reachable(const Graph& graph, const std::vector<Graph::Node>& roots) {
    std::vector<bool> flags(graph.size(), false);
    for (const Graph::Node root : roots) flags[static_cast<std::size_t>(root)] = true;
    for (std::size_t n = graph.size(); n > 0; --n)
        if (flags[n - 1])
            for (const Graph::Node operand : graph.at(static_cast<Graph::Node>(n - 1)).operands)
                flags[static_cast<std::size_t>(operand)] = true;
    return flags;
}

std::vector<bool> depending(const Graph& graph, const std::set<Graph::Node>& sources) {
    std::vector<bool> flags(graph.size(), false);
    for (std::size_t n = 0; n < graph.size(); ++n) {
        const std::vector<Graph::Node>& operands = graph.at(static_cast<Graph::Node>(n)).operands;
        flags[n] = sources.count(static_cast<Graph::Node>(n)) > 0 ||
                   std::any_of(operands.begin(), operands.end(),
                               [&](Graph::Node operand) { return flags[static_cast<std::size_t>(operand)]; });
    }
    return flags;
}

std::set<Graph::Node> varying_symbols(const Program& program) {
    std::set<Graph::Node> result{program.time, program.slow_time};
    for (const ProgramFlow& variable : program.flow) result.insert(variable.value);
    for (const ProgramTable& table : program.tables) result.insert(table.value);
    for (const ProgramPhase& phase : program.phases)
        for (const Graph::Node n : phase.symbols()) result.insert(n);
    return result;
}

bool varies(const Program& program, Graph::Node n) {
    return depending(program.graph, varying_symbols(program))[static_cast<std::size_t>(n)];
}

void prune(Program& program, const std::set<std::string>& kept_inputs) {
    const std::vector<bool> used = needed_nodes(program);
    const auto is_kept = [&](const ProgramInput& i) { return kept_inputs.count(i.name) > 0; };
    const auto is_used = [&](Graph::Node n) { return used[static_cast<std::size_t>(n)]; };
    keep(program.flow, [&](const ProgramFlow& f) { return is_used(f.value); });
    keep(program.tables, [&](const ProgramTable& t) { return is_used(t.value); });
    keep_phases(program, used);
    keep(program.start, [&](const ProgramInput& i) { return is_used(i.symbol) || is_kept(i); });
    keep(program.slow, [&](const ProgramOutput& o) { return is_used(o.value); });
    keep(program.names, [&](const ProgramOutput& o) { return is_used(o.value); });
    std::vector<bool> known = used; // eps and the slow time are there in any case
    known[static_cast<std::size_t>(program.eps)] = known[static_cast<std::size_t>(program.slow_time)] = true;
    for (std::vector<ProgramCondition>* conditions : {&program.positive, &program.layers})
        keep_first(*conditions, [&](Graph::Node n) { return is_about(program.graph, n, known); });

    // the default of a start value may need a parameter that nothing else does
    std::vector<Graph::Node> defaults;
    for (const ProgramInput& input : program.start) defaults.push_back(input.default_value);
    const std::vector<bool> in_defaults = reachable(program.graph, defaults);
    keep(program.parameters, [&](const ProgramInput& i) {
        return is_used(i.symbol) || in_defaults[static_cast<std::size_t>(i.symbol)] || is_kept(i);
    });
}

} // namespace resonform
