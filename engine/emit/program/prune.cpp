// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/prune.hpp"

#include "algebra/number/error.hpp"

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
        if (needed(c) && seen.insert(c.value).second) kept.push_back(std::move(c));
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
        keep_first(*conditions, [&](const ProgramCondition& c) {
            return (c.of < 0 || is_used(c.of)) && is_about(program.graph, c.value, known);
        });

    // the default of a start value may need a parameter that nothing else does
    std::vector<Graph::Node> defaults;
    for (const ProgramInput& input : program.start) defaults.push_back(input.default_value);
    const std::vector<bool> in_defaults = reachable(program.graph, defaults);
    keep(program.parameters, [&](const ProgramInput& i) {
        return is_used(i.symbol) || in_defaults[static_cast<std::size_t>(i.symbol)] || is_kept(i);
    });
}

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
