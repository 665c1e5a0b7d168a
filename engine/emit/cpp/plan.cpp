// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/plan.hpp"

#include "algebra/number/error.hpp"
#include "emit/cpp/names.hpp"
#include "emit/cpp/rounding.hpp"
#include "emit/cpp/walk.hpp"
#include "emit/program/prune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace resonform {

using Value = StraightLine::Value;

CppPlan::CppPlan(const Program& p, const std::vector<CppCallable>& beside) : program(&p), code(p) {
    assign_levels();
    lower_results();
    find_callables(beside);
    name_inputs();
    find_members(false);
    find_ranges();
    const bool native = range.native;
    find_members(true);
    find_ranges();
    conditions_apart = native && !range.native;
    if (conditions_apart) {
        find_members(false);
        find_ranges();
    }
    name_kept();
    find_phase_constants();
    std::vector<Value> results;
    for (const CppResult& result : outputs) results.push_back(result.value);
    fine_constants = !range.native && rounds_much(rounding_of_constants(p, code, results));
}

// Of the results, which have been lowered, and of the start.
void CppPlan::find_callables(const std::vector<CppCallable>& beside) {
    std::map<std::string, int> highest;
    const auto note = [&](const std::string& name, int derivative) {
        if (!name.empty()) highest[name] = std::max(highest[name], derivative);
    };
    for (std::size_t v = 0; v < code.size(); ++v)
        note(code.at(static_cast<Value>(v)).callable, code.at(static_cast<Value>(v)).index);
    std::vector<Graph::Node> defaults;
    for (const ProgramInput& input : program->start) defaults.push_back(input.default_value);
    const std::vector<bool> in_start = reachable(program->graph, defaults);
    for (std::size_t n = 0; n < in_start.size(); ++n)
        if (const Graph::Entry& e = program->graph.at(static_cast<Graph::Node>(n));
            in_start[n] && e.op == Graph::Op::callable)
            note(e.name, e.exponent);
    for (const CppCallable& callable : beside) note(callable.function, callable.derivatives);
    CppNames names;
    for (const auto& [function, derivatives] : highest) {
        const std::string name = cpp_callable_name(function);
        if (names.unique(function) != name)
            refuse({"the names of callables differ in C++, too",
                    fmt::format("{} would be {} once more", function, name),
                    "rename the function in the system",
                    {}});
        callables.push_back({function, name, names.unique("Function_" + function), derivatives});
    }
}

CppNames CppPlan::names_beside_callables() const {
    CppNames names;
    for (const CppCallable& callable : callables)
        for (const std::string& name : {callable.name, callable.type}) names.unique(name);
    return names;
}

std::map<Graph::Node, std::string> CppPlan::input_names() const {
    std::map<Graph::Node, std::string> names{{program->eps, "eps"}};
    for (const std::vector<ProgramInput>* list : {&program->parameters, &program->start})
        for (const ProgramInput& input : *list) names[input.symbol] = input.name;
    return names;
}

std::string CppPlan::callable_list(const char* form) const {
    std::string text;
    for (const CppCallable& callable : callables)
        text += (text.empty() ? "" : ", ") + fmt::format(fmt::runtime(form), fmt::arg("name", callable.name),
                                                         fmt::arg("type", callable.type));
    return text;
}

void CppPlan::name_inputs() {
    const auto unique = [this](const std::vector<ProgramInput>& inputs) {
        CppNames names = names_beside_callables();
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
        levels.push_back({true, "slow flow", {}});
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
        CppLevel& own = levels[level[k]];
        own.members.push_back(k);
        own.name += (own.name.empty() ? "" : " or ") + program->tables[k].name;
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

std::string CppPlan::conditions_text() const {
    std::string text;
    std::set<std::string> named;
    for (const CppCondition& condition : varying_conditions)
        if (named.insert(condition.quantity).second)
            text += (text.empty() ? "" : " or ") + condition.quantity;
    return text;
}

std::string CppPlan::member_list(const std::vector<Value>& values, const std::string& prefix) const {
    std::string text;
    for (const Value v : values) text += (text.empty() ? "" : ", ") + prefix + members.at(v);
    return text;
}

std::vector<std::size_t> CppPlan::fades_with(std::size_t phase) const {
    std::vector<std::size_t> list;
    for (const Graph::Node exponential : program->phases[phase].fades_with)
        for (std::size_t k = 0; k < program->phases.size(); ++k)
            if (program->phases[k].exponential == exponential) list.push_back(k);
    return list;
}

bool CppPlan::rounded_phases() const {
    return std::find(phase_uses_tables.begin(), phase_uses_tables.end(), true) != phase_uses_tables.end();
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
        if (phase.growth >= 0) growths.push_back({phase_names.size() - 1, code.lower(phase.growth)});
        for (const std::vector<Graph::Node>& either : phase.precision) {
            std::vector<Value>& list = precisions.emplace_back();
            for (const Graph::Node n : either) list.push_back(code.lower(n));
        }
        if (!loses_digits && (phase.growth >= 0 || !phase.precision.empty()))
            loses_digits = phase_names.size() - 1;
        const std::vector<bool> used = reachable(program->graph, {phase.rate});
        phase_uses_tables.push_back(
            std::any_of(looked_up.begin(), looked_up.end(),
                        [&](const Column& column) { return used[static_cast<std::size_t>(column.value)]; }));
        divided_rates.emplace_back();
        if (phase.main_rate < 0 || phase_uses_tables.back() || !code.at(phase_rates.back()).varying) continue;
        divided_rates.back() = {code.lower(phase.main_rate), code.lower(phase.small_rate)};
    }
    outputs = results(program->outputs);
    state = results(program->state);
    for (const ProgramData& data : program->data) data_arguments.push_back(code.lower(data.argument));
    for (const ProgramRow& row : program->rows) rows.push_back({&row, code.lower(row.amplitude)});
    if (program->many_points == EmitForm::atoms) recipe = recipe_of(*program, code);
    for (const ProgramCondition& condition : program->positive) {
        const Value v = code.lower(condition.value);
        (code.at(v).varying ? varying_conditions : constant_conditions).push_back({v, condition.quantity});
    }
    std::vector<Graph::Node> margins;
    for (const ProgramCondition& margin : program->layers) {
        layers.push_back({code.lower(margin.value), margin.quantity});
        margins.push_back(margin.value);
        layers_are_broad = layers_are_broad && margin.broad;
    }
    const std::vector<bool> behind_layers = reachable(program->graph, margins);
    for (const ProgramFlow& variable : program->flow)
        layers_use_flow = layers_use_flow || behind_layers[static_cast<std::size_t>(variable.value)];
    layers_have_bounds = !layers_use_flow && have_bounds(layers);
}

bool CppPlan::have_bounds(const std::vector<CppCondition>& margins) const {
    std::vector<Value> roots;
    for (const CppCondition& margin : margins) roots.push_back(margin.value);
    const std::vector<Value> all = code.behind_doubled(roots, false);
    return std::all_of(all.begin(), all.end(), [&](Value v) {
        const StraightLine::Instruction& i = code.at(v);
        if (!i.varying) return true;
        switch (i.op) {
        case StraightLine::Op::root: return i.index == 2;
        case StraightLine::Op::doubled: return false;
        case StraightLine::Op::function:
            return i.data == nullptr && i.callable.empty() &&
                   (i.function == Graph::Op::sqrt_sum_squares || i.function == Graph::Op::exp ||
                    i.function == Graph::Op::sin || i.function == Graph::Op::cos);
        default: return true;
        }
    });
}

// All results, except constant conditions.
std::vector<Value> CppPlan::roots() const {
    std::vector<Value> all = integrands;
    for (const std::vector<Value>* more :
         {&flow_starts, &flow_rates, &phase_starts, &phase_rates, &data_arguments})
        all.insert(all.end(), more->begin(), more->end());
    for (const std::optional<DividedRate>& rate : divided_rates)
        if (rate) all.insert(all.end(), {rate->main, rate->small});
    for (const Growth& growth : growths) all.push_back(growth.factor);
    for (const std::vector<Value>& either : precisions) all.insert(all.end(), either.begin(), either.end());
    for (const std::vector<CppCondition>* conditions : {&varying_conditions, &layers})
        for (const CppCondition& condition : *conditions) all.push_back(condition.value);
    if (!program->sums_rows)
        for (const CppResult& result : outputs) all.push_back(result.value);
    for (const CppResult& result : state) all.push_back(result.value);
    for (const Value v : tabulated()) all.push_back(v);
    if (recipe) all.insert(all.end(), recipe->constants.begin(), recipe->constants.end());
    return all;
}

bool CppPlan::divides_rates(bool all) const {
    const auto divided =
        std::count_if(divided_rates.begin(), divided_rates.end(),
                      [](const std::optional<DividedRate>& rate) { return rate.has_value(); });
    return divided > 0 && (!all || static_cast<std::size_t>(divided) == divided_rates.size());
}

std::vector<Value> CppPlan::tabulated() const {
    if (recipe) return recipe->atoms;
    std::vector<Value> values;
    for (const CppRow& row : rows) values.push_back(row.amplitude);
    return values;
}

// Constants that varying values use, and results that are constant; small integers are written in place.
void CppPlan::find_members(bool conditions) {
    std::vector<Value> all = roots();
    if (conditions)
        for (const CppCondition& condition : constant_conditions) all.push_back(condition.value);

    const std::map<Graph::Node, std::string> inputs = input_names();
    std::set<Value> in_any_case(phase_starts.begin(), phase_starts.end()); // whatever they are
    in_any_case.insert(flow_starts.begin(), flow_starts.end());
    for (const Growth& growth : growths) in_any_case.insert(growth.factor);
    for (const CppCondition& condition : constant_conditions) in_any_case.insert(condition.value);
    std::vector<Value> constants;
    for (const Value v : code.behind(all, false)) {
        const StraightLine::Instruction& i = code.at(v);
        const bool literal = i.op == StraightLine::Op::number && cln::denominator(i.number) == 1 &&
                             cln::abs(i.number) < (Integer(1) << 31) && in_any_case.count(v) == 0;
        if (!i.varying && !literal) constants.push_back(v);
    }
    CppNames names = names_beside_callables();
    members.clear();
    listed.clear();
    const bool in_array = is_long(constants);
    if (in_array) names.unique(list_name);
    const std::vector<Value> apart = read_by_phases();
    for (const Value v : constants) {
        const StraightLine::Instruction& i = code.at(v);
        const std::string wish = i.op == StraightLine::Op::symbol ? inputs.at(i.symbol) : i.label;
        if (!wish.empty() || !in_array || std::binary_search(apart.begin(), apart.end(), v)) {
            members[v] = wish.empty() ? names.numbered("c") : names.unique(wish);
            continue;
        }
        members[v] = fmt::format("{}[{}]", list_name, listed.size());
        listed.push_back(v);
    }
}

// Whether these constants take so many operations that a loop walks them, instead of statements.
bool CppPlan::is_long(const std::vector<Value>& constants) const {
    constexpr std::size_t longest = 2000;
    const std::vector<Value> order = code.behind(constants, true);
    return order.size() > longest && std::all_of(order.begin(), order.end(), [&](Value v) {
               return code.at(v).op == StraightLine::Op::symbol || can_be_walked(code.at(v));
           });
}

void CppPlan::find_ranges() {
    std::vector<Value> constants, defaults{code.lower(program->slow_time_end)};
    for (const auto& member : members) constants.push_back(member.first);
    range = constant_range(code, constants);
    for (const ProgramInput& input : program->start) defaults.push_back(code.lower(input.default_value));
    constexpr int one_factor = 500; // more than half of all exponents: no product of two arguments
    native_defaults = constant_range(code, defaults).bound > one_factor;
}

// For each value, a user of it that has a name known to readers.
std::vector<std::string> CppPlan::users() const {
    std::vector<std::string> user(code.size());
    const auto name = [&](Value v, const std::string& text) { user[static_cast<std::size_t>(v)] = text; };
    for (const std::vector<CppCondition>* conditions : {&layers, &varying_conditions})
        for (const CppCondition& condition : *conditions) name(condition.value, condition.quantity);
    for (std::size_t k = 0; k < phase_rates.size(); ++k) name(phase_rates[k], phase_names[k]);
    for (std::size_t k = 0; k < integrands.size(); ++k) name(integrands[k], program->tables[k].name);
    for (std::size_t k = 0; k < flow_rates.size(); ++k)
        for (const Value v : {flow_rates[k], flow_starts[k]}) name(v, program->flow[k].name);
    for (const CppRow& row : rows) name(row.amplitude, outputs[row.row->output].name);
    for (const std::vector<CppResult>* results : {&state, &outputs})
        for (const CppResult& result : *results) name(result.value, result.name);
    for (std::size_t v = code.size(); v > 0; --v) {
        const StraightLine::Instruction& i = code.at(static_cast<Value>(v - 1));
        if (!i.varying) continue;
        if (!i.label.empty()) user[v - 1] = i.label;
        for (const Value operand : i.operands)
            if (user[static_cast<std::size_t>(operand)].empty()) name(operand, user[v - 1]);
    }
    return user;
}

void CppPlan::name_kept() {
    const std::vector<std::string> user = users();
    for (const Value v : code.behind(roots(), false)) {
        const auto member = members.find(v);
        if (member == members.end()) continue;
        const std::string& in = user[static_cast<std::size_t>(v)];
        const bool known = !code.at(v).label.empty() || code.at(v).op == StraightLine::Op::symbol;
        const bool is_listed = std::binary_search(listed.begin(), listed.end(), v);
        std::string called = is_listed ? "a constant" : member->second;
        if (!known && !in.empty() && in != member->second) called.append(" in ").append(in);
        kept.emplace_back(v, std::move(called));
    }
}

// In more digits than Real has.
std::vector<Value> CppPlan::read_by_phases() const {
    std::vector<Value> read = phase_starts;
    for (std::size_t k = 0; k < phase_rates.size(); ++k)
        read.push_back(divides_rates(true) ? divided_rates[k]->main : phase_rates[k]);
    return code.behind_doubled(read, false);
}

void CppPlan::find_phase_constants() {
    if (program->phases.empty() || !program->data.empty() || !callables.empty()) return;
    std::vector<Value> all, some;
    for (const auto& member : members) all.push_back(member.first);
    for (const Value v : read_by_phases())
        if (members.count(v) != 0) some.push_back(v);
    // Of constants that a loop walks they are the first, and cost no text.
    const std::size_t as_few = walks_constants() ? 1 : 2;
    const bool much_less = as_few * code.behind(some, true).size() < code.behind(all, true).size();
    if (much_less) phase_constants = some;
}

std::vector<std::string> CppPlan::output_arrays() const {
    std::vector<std::string> names;
    for (const CppResult& output : outputs) {
        const bool taken =
            output.name == "n" || output.name == "t0" || output.name == "dt" || output.name == "members";
        names.push_back(taken ? output.name + "_" : output.name);
    }
    return names;
}

} // namespace resonform
