// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/stages.hpp"

#include "emit/cpp/constants.hpp"
#include "emit/cpp/data.hpp"
#include "emit/cpp/function.hpp"
#include "emit/cpp/names.hpp"
#include "emit/cpp/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

using Value = StraightLine::Value;

class CppStages {
public:
    explicit CppStages(CppPlan& plan) : program_(*plan.program), plan_(plan) {}

    std::string print() {
        return cpp_constants(plan_) + cpp_data_edges(plan_) + flow_rates() + layers() + integrands() +
               phase_rates() + arguments() + cpp_row_list(plan_) +
               evaluation("outputs", "Values", plan_.outputs, program_.sums_rows) +
               evaluation("states", "State", plan_.state) + passes() + amplitudes() + recipe_constants();
    }

private:
    std::string flow_rates();
    std::string layers();
    std::string integrands();
    std::string integrands_of(std::size_t level);
    std::string phase_rates();
    std::string rate_of(Value rate, const std::string& name, bool uses_tables, bool some);
    std::string arguments() const;
    std::string evaluation(const std::string& name, const std::string& type,
                           const std::vector<CppResult>& list, bool from_rows = false);
    std::string passes();
    void know_call(CppFunction& function);
    std::string amplitudes();
    std::string recipe_constants();
    void know_members(CppFunction& function) const;
    void know_tables(CppFunction& function, const std::string& array);

    const Program& program_;
    CppPlan& plan_;
};

void CppStages::know_members(CppFunction& function) const {
    for (const auto& [value, name] : plan_.members) function.know(value, "c." + name);
}

void CppStages::know_tables(CppFunction& function, const std::string& array) {
    std::size_t place = 0;
    for (const CppPlan::Column& column : plan_.columns())
        function.define(plan_.code.lower(column.value), column.name, fmt::format("{}[{}]", array, place++));
}

// The slow flow: its rates at T and at values of its own.
std::string CppStages::flow_rates() {
    if (program_.flow.empty()) return "";
    CppFunction function(plan_.code, "Number", "q", plan_.lies);
    know_members(function);
    function.know(plan_.code.lower(program_.slow_time), "T");
    know_tables(function, "flow");
    function.compute(plan_.flow_rates, false);
    std::vector<std::string> names, texts;
    for (std::size_t k = 0; k < program_.flow.size(); ++k) {
        names.push_back(fmt::format("d{}/dT", program_.flow[k].name));
        texts.push_back("Number(" + function.text(plan_.flow_rates[k]) + ")");
    }
    const std::string type = fmt::format("std::array<Number, {}>", program_.flow.size());
    return fmt::format(
        "    // The slow flow: {}\n{}\n", fmt::join(names, ", "),
        function.print(
            {"template <class Number> static",
             type,
             "flow_rates",
             {{"const Constants<Number>&", "c"}, {"const Number&", "T"}, {"const " + type + "&", "flow"}},
             {},
             {fmt::format("return {{{}}};", fmt::join(texts, ", "))}}));
}

std::string CppStages::layers() {
    if (plan_.layers.empty()) return "";
    CppFunction function(plan_.code, "Number", "q", plan_.lies);
    know_members(function);
    function.know(plan_.code.lower(program_.slow_time), "T");
    know_tables(function, "flow");
    std::vector<Value> margins;
    for (const CppCondition& margin : plan_.layers) margins.push_back(margin.value);
    function.compute(margins, false);
    std::vector<std::string> texts;
    for (const Value margin : margins) texts.push_back("Number(" + function.text(margin) + ")");
    const bool bounded = plan_.layers_have_bounds;
    CppFunction::Frame frame{
        bounded ? "template <class Number, class Constant> static" : "template <class Number> static",
        fmt::format("std::array<Number, {}>", texts.size()),
        "layers",
        {{bounded ? "const Constants<Constant>&" : "const Constants<Number>&", "c"}, {"const Number&", "T"}},
        {},
        {fmt::format("return {{{}}};", fmt::join(texts, ", "))}};
    if (plan_.layers_use_flow)
        frame.parameters.emplace_back(fmt::format("const std::array<Number, {}>&", program_.flow.size()),
                                      "flow");
    return "    // All > 0, or a divisor D that moves is too small, |D|^2 <= |dD/dt|, or the first "
           "corrections of the\n"
           "    // map are half of the amplitudes, or a slow variable came to rest long ago.\n" +
           function.print(frame) + "\n";
}

std::string CppStages::integrands() {
    std::string text;
    for (std::size_t level = 0; level < plan_.levels.size(); ++level)
        if (!plan_.levels[level].flow) text += integrands_of(level);
    return text;
}

std::string CppStages::integrands_of(std::size_t level) {
    CppFunction function(plan_.code, "Number", "q", plan_.lies);
    know_members(function);
    function.know(plan_.code.lower(program_.slow_time), "T");
    know_tables(function, "tables");
    std::vector<Value> roots;
    std::vector<std::string> names, texts;
    for (const std::size_t k : plan_.levels[level].members) {
        roots.push_back(plan_.integrands[k]);
        names.push_back("d" + program_.tables[k].name + "/dT");
    }
    function.compute(roots, false);
    for (const Value root : roots) texts.push_back("Number(" + function.text(root) + ")");
    const std::string type = fmt::format("std::array<Number, {}>", roots.size());
    CppFunction::Frame frame{"template <class Number> static",
                             type,
                             fmt::format("integrands_{}", level),
                             {{"const Constants<Number>&", "c"}, {"const Number&", "T"}},
                             {},
                             {fmt::format("return {{{}}};", fmt::join(texts, ", "))}};
    if (level > 0)
        frame.parameters.emplace_back(
            fmt::format("const std::array<Number, {}>&", plan_.columns_before(level)), "tables");
    return fmt::format("    // {}\n{}\n", fmt::join(names, ", "), function.print(frame));
}

std::string CppStages::phase_rates() {
    std::string text;
    for (std::size_t k = 0; k < program_.phases.size(); ++k) {
        const std::string& name = plan_.phase_names[k];
        text += fmt::format("    // d{}/dT\n", name) + rate_of(plan_.phase_rates[k], name + "_rate",
                                                               plan_.phase_uses_tables[k],
                                                               plan_.whole_rates_read_some());
        if (const auto& divided = plan_.divided_rates[k])
            text += "    // The same as a sum, of which the second part turns little.\n" +
                    rate_of(divided->main, name + "_main_rate", false, true) +
                    rate_of(divided->small, name + "_small_rate", false, false);
    }
    return text;
}

// some: of an object that holds no more constants than it needs.
std::string CppStages::rate_of(Value rate, const std::string& name, bool uses_tables, bool some) {
    CppFunction function(plan_.code, "Number", "q", plan_.lies);
    know_members(function);
    function.know(plan_.code.lower(program_.slow_time), "T");
    know_tables(function, "tables");
    function.compute({rate}, false);
    CppFunction::Frame frame{
        some ? "template <class Number, class Some> static" : "template <class Number> static",
        "Number",
        name,
        {{some ? "const Some&" : "const Constants<Number>&", "c"}, {"const Number&", "T"}},
        {},
        {fmt::format("return {};", function.text(rate))}};
    if (uses_tables)
        frame.parameters.emplace_back(
            fmt::format("const std::array<Number, {}>&", plan_.columns_before(plan_.levels.size())),
            "tables");
    return function.print(frame) + "\n";
}

std::string CppStages::arguments() const {
    std::string text = "    // What differs from call to call.\n    struct Arguments {\n        Real T{}; // "
                       "slow time eps t\n";
    if (!plan_.levels.empty())
        text += fmt::format("        std::array<Real, {}> tables{{}};\n",
                            plan_.columns_before(plan_.levels.size()));
    for (std::size_t k = 0; k < program_.phases.size(); ++k)
        text += fmt::format(fmt::runtime(program_.phases[k].decays()
                                             ? "        Real exp_{0}{{}};\n"
                                             : "        Real cos_{0}{{}}, sin_{0}{{}};\n"),
                            plan_.phase_names[k]);
    return text + "    };\n\n";
}

void CppStages::know_call(CppFunction& function) {
    know_members(function);
    function.know(plan_.code.lower(program_.slow_time), "a.T");
    know_tables(function, "a.tables");
    for (std::size_t k = 0; k < program_.phases.size(); ++k) {
        const ProgramPhase& phase = program_.phases[k];
        if (phase.decays()) {
            function.know(plan_.code.lower(phase.exponential), "a.exp_" + plan_.phase_names[k]);
            continue;
        }
        function.know(plan_.code.lower(phase.cosine), "a.cos_" + plan_.phase_names[k]);
        function.know(plan_.code.lower(phase.sine), "a.sin_" + plan_.phase_names[k]);
    }
}

// Whether digits are left where a growth rate changes its sign (emit/program/passage.hpp) or a small divisor
// vanishes (emit/program/layers.hpp).
std::string CppStages::passes() {
    if (plan_.precisions.empty()) return "";
    CppFunction function(plan_.code, "Real", "q", plan_.lies);
    know_call(function);
    std::vector<Value> roots;
    for (const std::vector<Value>& either : plan_.precisions)
        roots.insert(roots.end(), either.begin(), either.end());
    function.compute(roots, false);
    std::vector<std::string> all;
    for (const std::vector<Value>& either : plan_.precisions) {
        std::vector<std::string> list;
        for (const Value v : either) list.push_back(function.text(v) + " > Real(0)");
        all.push_back(fmt::format("({})", fmt::join(list, " || ")));
    }
    const CppFunction::Frame frame{"static", "bool",
                                   "passes", {{"const Constants<Real>&", "c"}, {"const Arguments&", "a"}},
                                   {},       {fmt::format("return {};", fmt::join(all, " && "))}};
    return "    // Where a rate or a divisor changes its sign, digits are left.\n" + function.print(frame) +
           "\n";
}

std::string CppStages::evaluation(const std::string& name, const std::string& type,
                                  const std::vector<CppResult>& list, bool from_rows) {
    if (list.empty()) return "";
    CppFunction function(plan_.code, "Real", "q", plan_.lies);
    know_call(function);
    std::vector<Value> roots;
    for (const CppCondition& condition : plan_.varying_conditions) roots.push_back(condition.value);
    if (!from_rows)
        for (const CppResult& result : list) roots.push_back(result.value);
    function.compute(roots, false);

    CppFunction::Frame frame{
        "static", "Status",
        name,     {{"const Constants<Real>&", "c"}, {"const Arguments&", "a"}, {type + "&", "values"}},
        {},       {}};
    for (const CppCondition& condition : plan_.varying_conditions)
        frame.last.push_back(fmt::format("if (!({} > Real(0))) return Status::outside_domain;",
                                         function.text(condition.value)));
    if (from_rows)
        for (std::string& line : cpp_sums(plan_)) frame.last.push_back(std::move(line));
    std::vector<std::string> finite;
    for (std::size_t k = 0; k < list.size(); ++k) {
        const std::string text = from_rows ? fmt::format("sums[{}]", k) : function.text(list[k].value);
        frame.last.push_back(fmt::format("values.{} = {};", list[k].name, text));
        finite.push_back(fmt::format("finite(values.{})", list[k].name));
    }
    frame.last.push_back(
        fmt::format("return {} ? Status::ok : Status::overflow;", fmt::join(finite, " && ")));
    return function.print(frame) + "\n";
}

std::string CppStages::amplitudes() {
    const std::vector<Value> tabulated = plan_.tabulated();
    if (!program_.has_tables() && !program_.sums_rows) return "";
    CppFunction function(plan_.code, "Number", "q", plan_.lies);
    know_members(function);
    function.know(plan_.code.lower(program_.slow_time), "T");
    know_tables(function, "tables");
    std::vector<Value> roots;
    for (const CppCondition& condition : plan_.varying_conditions) roots.push_back(condition.value);
    roots.insert(roots.end(), tabulated.begin(), tabulated.end());
    function.compute(roots, false);
    const std::string type = fmt::format("std::array<Number, {}>", tabulated.size());
    std::vector<std::string> conditions, texts;
    for (const CppCondition& condition : plan_.varying_conditions)
        conditions.push_back(fmt::format("{} > Number(0)", function.text(condition.value)));
    for (const Value v : tabulated) texts.push_back("Number(" + function.text(v) + ")");
    CppFunction::Frame frame{"template <class Number> static",
                             type,
                             "amplitudes",
                             {{"const Constants<Number>&", "c"}, {"const Number&", "T"}},
                             {},
                             {}};
    if (!plan_.levels.empty())
        frame.parameters.emplace_back(
            fmt::format("const std::array<Number, {}>&", plan_.columns_before(plan_.levels.size())),
            "tables");
    if (!conditions.empty()) {
        frame.last.push_back(type + " none;");
        frame.last.emplace_back("none.fill(resonform::math::not_a_number<Number>());");
        frame.last.push_back(fmt::format("if (!({})) return none;", fmt::join(conditions, " && ")));
    }
    for (std::string& line : cpp_return_list(plan_, type, tabulated, texts))
        frame.last.push_back(std::move(line));
    return "    // Of the rows; NaN outside of the domain.\n" + function.print(frame) + "\n";
}

// Those that the operations of many points need.
std::string CppStages::recipe_constants() {
    if (!plan_.recipe) return "";
    CppFunction function(plan_.code, "Real", "q", plan_.lies);
    know_members(function);
    function.compute(plan_.recipe->constants, false);
    std::vector<std::string> texts;
    for (const Value v : plan_.recipe->constants) texts.push_back("Real(" + function.text(v) + ")");
    const std::string type = fmt::format("std::array<Real, {}>", texts.size());
    return function.print({"static",
                           type,
                           "recipe_constants",
                           {{"const Constants<Real>&", "c"}},
                           {},
                           {fmt::format("return {{{}}};", fmt::join(texts, ", "))}}) +
           "\n";
}

} // namespace

std::string cpp_stages(CppPlan& plan) { return CppStages(plan).print(); }

} // namespace resonform
