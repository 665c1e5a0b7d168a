// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/class.hpp"

#include "emit/cpp/begin.hpp"
#include "emit/cpp/data.hpp"
#include "emit/cpp/embedded_text.hpp"
#include "emit/cpp/final_point.hpp"
#include "emit/cpp/interface.hpp"
#include "emit/cpp/names.hpp"
#include "emit/cpp/plan.hpp"
#include "emit/cpp/rows.hpp"
#include "emit/cpp/stages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

namespace resonform {

namespace {

class CppFrame {
public:
    CppFrame(const CppPlan& plan, const std::vector<PlannedFurther>& further)
        : program_(*plan.program), plan_(plan), further_(further) {}

    std::string print() const {
        return aliases() + cpp_further_arguments(plan_, further_) + look_up() + precise() + locate() +
               points() + rows() + cpp_begin(plan_) + cpp_course(plan_) + construct() + data_members();
    }

private:
    std::string aliases() const;
    std::string look_up() const;
    std::string precise() const;
    std::string locate() const;
    std::string unless_faded(std::size_t phase) const;
    std::string points() const;
    std::string rows() const;
    std::string recipe() const;
    std::string rates() const;
    std::string flow(std::size_t level) const;
    std::string layers() const;
    std::string kept_arguments() const;
    std::string construct() const;
    std::string data_members() const;
    // Whether Parameters hold anything.
    bool has_parameters() const { return !program_.parameters.empty() || !plan_.callables.empty(); }
    // For numbers that are computed when tables are built.
    std::string parameters() const { return has_parameters() ? "of.parameters_" : "Parameters{}"; }
    std::string constants_function(const std::string& which) const {
        return (plan_.range.native ? "compute_" : "keep_") + which;
    }
    // Tables are kept in Real; what needs them takes them as they are.
    std::string widened_tables(const char* number, const char* of = "") const {
        return fmt::format("widened<{}>({}look_up_{}(static_cast<Real>(T)))", number, of,
                           plan_.levels.size());
    }

    const Program& program_;
    const CppPlan& plan_;
    const std::vector<PlannedFurther>& further_;
};

std::string CppFrame::aliases() const {
    std::string text =
        "    using Cause = resonform::Cause;\n    using Interval = resonform::Interval<Real>;\n";
    if (!program_.phases.empty()) text += "    using Wide = resonform::WideNumber<Real>;\n";
    if (program_.has_tables() || plan_.fine_constants)
        text += "    using Fine = resonform::math::Fine<Real>;\n";
    return text + "\n";
}

// The values of all tables below a level.
std::string CppFrame::look_up() const {
    std::string text;
    for (std::size_t level = 1; level <= plan_.levels.size(); ++level) {
        const std::string type = fmt::format("std::array<Real, {}>", plan_.columns_before(level));
        text += fmt::format("    {} look_up_{}(const Real& T) const noexcept {{\n", type, level);
        if (level == 1) {
            text += "        return tables_0_(T);\n    }\n\n";
            continue;
        }
        text += filled(frames::look_up, {{"before", std::to_string(level - 1)}, {"array", type}});
    }
    return text;
}

std::string CppFrame::locate() const {
    const char* low = program_.phases.empty() ? "[[maybe_unused]] const Real& low" : "const Real& low";
    std::string text = "    // The arguments at t + low.\n"
                       "    Status locate(const Real& t, " +
                       std::string(low) +
                       ", Arguments& a) const noexcept {\n"
                       "        if (cause_.status != Status::ok) return cause_.status;\n";
    if (plan_.levels.empty() && program_.phases.empty())
        return text + "        return interval_.locate(t, a.T);\n    }\n\n";
    text += "        if (const Status located = interval_.locate(t, a.T); located != Status::ok) return "
            "located;\n";
    if (!plan_.levels.empty())
        text += fmt::format("        a.tables = look_up_{}(a.T);\n", plan_.levels.size());
    if (program_.phases.empty()) return text + "        return Status::ok;\n    }\n\n";
    for (std::size_t k = 0; k < program_.phases.size(); ++k)
        if (program_.phases[k].decays())
            text += fmt::format("        a.exp_{0} = {0}_(t, low);\n", plan_.phase_names[k]);
    text += "        Status status = Status::ok;\n";
    for (std::size_t k = 0; k < program_.phases.size(); ++k)
        if (!program_.phases[k].decays())
            text += fmt::format("        if (const Status seen = {0}_(t, low, a.cos_{0}, a.sin_{0}); seen != "
                                "Status::ok{1}) status = seen;\n",
                                plan_.phase_names[k], unless_faded(k));
    return text +
           (!plan_.loses_digits ? ""
                                : "        if (!precise(constants_, a)) status = Status::low_precision;\n") +
           "        return status;\n    }\n\n";
}

// Whether modes that grow and divisors that vanish leave digits.
std::string CppFrame::precise() const {
    if (!plan_.loses_digits) return "";
    std::vector<std::string> all;
    for (const CppPlan::Growth& growth : plan_.growths)
        all.push_back(fmt::format("a.exp_{} * c.{} <= Real(1)", plan_.phase_names[growth.phase],
                                  plan_.members.at(growth.factor)));
    if (!plan_.precisions.empty()) all.emplace_back("passes(c, a)");
    return fmt::format("    // Whether digits are left.\n"
                       "    static bool precise(const Constants<Real>& c, const Arguments& a) noexcept {{\n"
                       "        return {};\n    }}\n\n",
                       fmt::join(all, " && "));
}

// " && !resonform::faded(a.exp_chi)" of a phase with which only decaying modes turn.
std::string CppFrame::unless_faded(std::size_t phase) const {
    std::vector<std::string> with;
    for (const std::size_t k : plan_.fades_with(phase)) with.push_back("a.exp_" + plan_.phase_names[k]);
    return with.empty() ? "" : fmt::format(" && !resonform::faded({})", fmt::join(with, ", "));
}

// What Points and Tabulated call.
std::string CppFrame::points() const {
    std::string text = "    friend struct resonform::Points;\n    friend struct resonform::Ensemble;\n";
    if (program_.has_tables()) text += "    friend struct resonform::Tabulated;\n";
    text += "\n" + cpp_call("at", "Values", "outputs", plan_.outputs);
    text += "    static void list(const Values& values, Real* numbers) noexcept {\n";
    for (std::size_t k = 0; k < plan_.outputs.size(); ++k)
        text += fmt::format("        numbers[{}] = values.{};\n", k, plan_.outputs[k].name);
    return text + "    }\n\n";
}

// How the outputs are made of atoms.
std::string CppFrame::recipe() const {
    static constexpr std::array kinds{"product",           "scaled",     "sum",
                                      "difference",        "shifted",    "multiply_add",
                                      "multiply_subtract", "scaled_add", "scaled_subtract",
                                      "constant"};
    if (!plan_.recipe) return "";
    const Recipe& recipe = *plan_.recipe;
    std::string list;
    for (const Recipe::Operation& o : recipe.operations)
        list += fmt::format("            {{Kind::{}, {}, {}, {}, {}}},\n",
                            kinds[static_cast<std::size_t>(o.kind)], o.to, o.a, o.b, o.c);
    return filled(frames::recipe, {{"operations", std::to_string(recipe.operations.size())},
                                   {"list", list},
                                   {"outputs", std::to_string(recipe.results.size())},
                                   {"results", fmt::format("{}", fmt::join(recipe.results, ", "))},
                                   {"turns", std::to_string(recipe.turns)},
                                   {"fades", std::to_string(recipe.fades)},
                                   {"constants", std::to_string(recipe.constants.size())}});
}

std::string CppFrame::rates() const {
    if (program_.phases.empty()) return "";
    std::vector<std::string> list;
    for (std::size_t k = 0; k < program_.phases.size(); ++k) {
        const std::string tables = plan_.phase_uses_tables[k] ? ", " + widened_tables("Wide", "of.") : "";
        list.push_back(fmt::format("{}_rate(c, T{})", plan_.phase_names[k], tables));
    }
    return filled(frames::rates, {{"phases", std::to_string(program_.phases.size())},
                                  {"constants", constants_function(plan_.rate_constants())},
                                  {"Constants", plan_.rate_constants_type()},
                                  {"parameters", parameters()},
                                  {"starts", plan_.member_list(plan_.phase_starts, "c.")},
                                  {"rates", fmt::format("{}", fmt::join(list, ", "))}});
}

std::string CppFrame::rows() const {
    if (!program_.has_tables()) return "";
    const auto decays = std::count_if(program_.phases.begin(), program_.phases.end(),
                                      [](const ProgramPhase& phase) { return phase.decays(); });
    return filled(
        frames::rows,
        {{"phases", std::to_string(program_.phases.size())},
         {"decays", decays == 0 ? "" : fmt::format("decays = {}, ", decays)},
         {"outputs", std::to_string(plan_.outputs.size())},
         {"rows", std::to_string(plan_.tabulated().size())},
         {"terms", cpp_terms(plan_)},
         {"recipe", recipe()},
         {"what", plan_.recipe ? "The outputs by operations on atoms and turned modes"
                               : "The outputs as sums of rows: amplitudes times 1, cosines and sines"},
         {"constants", constants_function("constants")},
         {"parameters", parameters()},
         {"tables", plan_.levels.empty() ? "" : ", " + widened_tables("Fine", "of.")},
         {"rates", rates()},
         {"rounded", plan_.rounded_phases() ? "true" : "false"}});
}

// Builds a table as far as it goes; if that is nowhere, the construction returns the failure.
std::string built_or_return(const std::string& call) { return filled(frames::shorten, {{"call", call}}); }
std::string built_or_return(const std::string& call, const std::string& what) {
    return built_or_return(fmt::format("{{{}, {}}}", call, cpp_literal(what)));
}

std::string CppFrame::flow(std::size_t level) const {
    const auto at = [&](const std::string& value, bool uses_flow) {
        return fmt::format("[this](const Real& T, const std::array<Real, {}>&{}) {{ return {}; }}",
                           program_.flow.size(), uses_flow ? " flow" : "", value);
    };
    const std::string indent = "\n                              ";
    std::string layers;
    if (!plan_.layers.empty())
        layers = indent +
                 at(fmt::format("resonform::all_clear(layers(constants_, T{}))",
                                plan_.layers_use_flow ? ", flow" : ""),
                    plan_.layers_use_flow) +
                 ",";
    return built_or_return(
        fmt::format("tables_{}_.build{}({},{}{}{{{}}}, reach)", level, layers.empty() ? "" : "_while",
                    cpp_in_pieces(plan_, at("flow_rates(constants_, T, flow)", true), "constants_"), layers,
                    indent, plan_.member_list(plan_.flow_starts, "constants_.")),
        plan_.levels[level].name);
}

std::string CppFrame::layers() const {
    if (plan_.layers.empty()) return "";
    std::vector<std::string> names;
    for (const CppCondition& margin : plan_.layers) names.push_back(cpp_literal(margin.quantity));
    return built_or_return(fmt::format(
        "resonform::clear_of_layers([this](const Real& T) {{ return layers(constants_, T{}); }},\n"
        "                                           std::array{{{}}}, reach{})",
        plan_.layers_use_flow ? ", look_up_1(T)" : "", fmt::join(names, ", "),
        plan_.layers_are_broad ? ", resonform::broad_layer_samples" : ""));
}

// For tables that are built later.
std::string CppFrame::kept_arguments() const {
    if (!program_.has_tables()) return "";
    const std::string text = has_parameters() ? "        parameters_ = parameters;\n" : "";
    return text + "        eps_ = eps;\n        start_ = start;\n";
}

std::string CppFrame::construct() const {
    std::string text =
        "    Cause construct(const Real& eps, const Parameters& parameters, const Start& start,\n"
        "                     const Real& end) {\n"
        "        if (const Cause bad = Interval::check(eps, end); bad.status != Status::ok) return bad;\n"
        "        interval_ = Interval(eps, end);\n" +
        kept_arguments() +
        "        if (const Cause bad = begin(eps, parameters, start, constants_); bad.status != Status::ok) "
        "return "
        "bad;\n";
    if (!plan_.levels.empty() || !program_.phases.empty() || !plan_.layers.empty())
        text += "        Real reach = end; // less where the domain ends before\n";
    if (program_.flow.empty()) text += layers();
    for (std::size_t level = 0; level < plan_.levels.size(); ++level) {
        if (plan_.levels[level].flow) {
            text += flow(level) + layers();
            continue;
        }
        const std::string tables = level == 0 ? "" : fmt::format(", look_up_{}(T)", level);
        text += built_or_return(
            fmt::format("tables_{}_.build({}, reach)", level,
                        cpp_in_pieces(
                            plan_,
                            fmt::format("[this](const Real& T) {{ return integrands_{}(constants_, T{}); }}",
                                        level, tables),
                            "constants_")),
            plan_.levels[level].name);
    }
    if (!program_.phases.empty())
        text += fmt::format("        {}<Wide> wide;\n", plan_.rate_constants_type()) +
                cpp_constants_call(plan_, plan_.rate_constants(), "wide");
    for (std::size_t k = 0; k < program_.phases.size(); ++k) {
        const std::string& name = plan_.phase_names[k];
        std::string rate = fmt::format("{}_rate(wide, T)", name);
        if (plan_.phase_uses_tables[k])
            rate = fmt::format("{}_rate(wide, T, {})", name, widened_tables("Wide"));
        text += fmt::format(
            "        const auto {}_rates = {};\n", name,
            cpp_in_pieces(plan_,
                          fmt::format("[&](const Wide& T) {{ return std::array<Wide, 1>{{{}}}; }}", rate),
                          "wide"));
        const bool fades = !program_.phases[k].fades_with.empty();
        const char* rounded = plan_.phase_uses_tables[k] ? ", true" : fades ? ", false" : "";
        text += built_or_return(fmt::format("{0}_.build({0}_rates, wide.{1}, eps, reach{2}{3})", name,
                                            plan_.members.at(plan_.phase_starts[k]), rounded,
                                            fades ? ", true" : ""),
                                name);
    }
    return text + "        return {};\n    }\n\n";
}

std::string CppFrame::data_members() const {
    std::string text;
    for (std::size_t level = 0; level < plan_.levels.size(); ++level) {
        const std::size_t size = plan_.levels[level].members.size();
        const std::string type = plan_.levels[level].flow
                                     ? fmt::format("FlowTable<std::array<Real, {}>>", size)
                                     : fmt::format("PrimitiveTable<Real, {}>", size);
        text += fmt::format("    resonform::{} tables_{}_;\n", type, level);
    }
    for (std::size_t k = 0; k < program_.phases.size(); ++k)
        text += fmt::format("    resonform::{}<Real> {}_;\n", program_.phases[k].decays() ? "Decay" : "Phase",
                            plan_.phase_names[k]);
    if (program_.has_tables()) {
        if (has_parameters()) text += "    Parameters parameters_;\n";
        text += "    Real eps_{};\n    Start start_;\n    resonform::SharedTables shared_;\n";
    }
    return cpp_further_members(plan_, further_) +
           "    Constants<Real> constants_{};\n    Interval interval_;\n" + text + "    Cause cause_;\n";
}

} // namespace

std::string cpp_class(const Program& program, const std::vector<CppFurther>& further, CppLies* lies) {
    const std::vector<PlannedFurther> planned_further = planned(further);
    CppPlan plan(program, callables_of(planned_further));
    plan.lies = lies;
    const std::string parameters =
        plan.callables.empty() ? "class Real = double" : "class Real, " + plan.callable_list("class {type}");
    return "template <" + parameters +
           "> class Evaluator {\npublic:\n    using Status = "
           "resonform::Status;\n    using BatchReport = resonform::BatchReport;\n\n" +
           cpp_interface(plan, planned_further) + "private:\n" + cpp_fields(plan) + cpp_stages(plan) +
           CppFrame(plan, planned_further).print() + "};\n";
}

} // namespace resonform
