// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/final_point.hpp"

#include "emit/cpp/embedded_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>

namespace resonform {

namespace {

class CppCourse {
public:
    explicit CppCourse(const CppPlan& plan) : program_(*plan.program), plan_(plan) {}

    std::string print() const;

private:
    // Of a row, the columns before a level.
    [[nodiscard]] std::string before(std::size_t level) const {
        const std::size_t some = plan_.columns_before(level), all = plan_.columns_before(plan_.levels.size());
        return some == all ? "row" : fmt::format("resonform::first<{}>(row)", some);
    }
    [[nodiscard]] std::string rates() const;
    [[nodiscard]] std::string margins() const;
    [[nodiscard]] std::string conditions() const;
    [[nodiscard]] std::string phase_rates() const;
    [[nodiscard]] std::string divided_rates() const;
    [[nodiscard]] std::string constants() const;
    [[nodiscard]] std::string own_constants() const;
    [[nodiscard]] std::string arguments() const;

    const Program& program_;
    const CppPlan& plan_;
};

std::string CppCourse::rates() const {
    std::string text;
    for (std::size_t level = 0; level < plan_.levels.size(); ++level) {
        const CppLevel& own = plan_.levels[level];
        const std::string call =
            own.flow ? fmt::format("flow_rates(c, T, {})", before(level + 1))
                     : fmt::format("integrands_{}(c, T{})", level, level == 0 ? "" : ", " + before(level));
        text +=
            fmt::format("        std::array<Real, {0}> rates(std::integral_constant<std::size_t, {1}>, const "
                        "Real& T, {2}const Columns& row) const {{\n            return {3};\n        }}\n",
                        own.members.size(), level,
                        call.find("row") == std::string::npos ? "[[maybe_unused]] " : "", call);
    }
    return text;
}

std::string CppCourse::margins() const {
    if (plan_.layers.empty()) return "";
    const bool flow = plan_.layers_use_flow;
    return fmt::format("        static constexpr int samples = resonform::{}layer_samples;\n"
                       "        auto margins(const Real& T{}) const {{ return layers(c, T{}); }}\n{}",
                       plan_.layers_are_broad ? "broad_" : "", flow ? ", const Columns& row" : "",
                       flow ? ", " + before(1) : "",
                       plan_.layers_have_bounds ? "        auto margins(const resonform::Bounds<Real>& T) "
                                                  "const { return layers(c, T); }\n"
                                                : "");
}

// What must be > 0 at the start; no more than Real has a place for.
std::string CppCourse::conditions() const {
    if (plan_.constant_conditions.empty()) return "";
    std::vector<StraightLine::Value> values;
    for (const CppCondition& condition : plan_.constant_conditions) values.push_back(condition.value);
    const std::string list = plan_.conditions_apart ? "start_conditions<Real>(eps, parameters, given)"
                                                    : fmt::format("std::array<Real, {}>{{{}}}", values.size(),
                                                                  plan_.member_list(values, "c."));
    return fmt::format("        auto conditions() const {{ return {}; }}\n", list);
}

std::string CppCourse::phase_rates() const {
    std::vector<std::string> list;
    for (std::size_t k = 0; k < program_.phases.size(); ++k)
        list.push_back(fmt::format("{}_rate(constants(course), T{})", plan_.phase_names[k],
                                   plan_.phase_uses_tables[k] ? ", widened<Number>(row)" : ""));
    return fmt::format("{}", fmt::join(list, ", "));
}

// Of each phase the part of its rate that is summed in Number, and the one for which Real suffices.
std::string CppCourse::divided_rates() const {
    if (!plan_.divides_rates()) return "";
    std::vector<std::string> main, small;
    for (std::size_t k = 0; k < program_.phases.size(); ++k) {
        const std::string& name = plan_.phase_names[k];
        const bool divided = plan_.divided_rates[k].has_value();
        main.push_back(divided ? name + "_main_rate(constants(course), T)"
                               : "whole[" + std::to_string(k) + "]");
        small.push_back(divided ? name + "_small_rate(course.c, T)" : "Real(0)");
    }
    const bool all = plan_.divides_rates(true);
    return filled(frames::divided_rates, {{"phases", std::to_string(program_.phases.size())},
                                          {"whole", all ? ""
                                                        : "                const std::array<Number, " +
                                                              std::to_string(program_.phases.size()) +
                                                              "> whole = (*this)(course, T, row);\n"},
                                          {"main", fmt::format("{}", fmt::join(main, ", "))},
                                          {"small", fmt::format("{}", fmt::join(small, ", "))}});
}

// Of the phases, in Number.
std::string CppCourse::constants() const {
    if (program_.phases.empty() && program_.data.empty()) return "";
    const auto compute = [this](const std::string& which) {
        return fmt::format("{}_{}(course.eps, course.parameters, course.given, own)",
                           plan_.range.native ? "compute" : "lost = keep", which);
    };
    std::string text = "                ";
    if (plan_.main_rates_read_some())
        text += fmt::format("if constexpr (resonform::divides_rates<Number, Real>) {{\n"
                            "                    {};\n                }} else ",
                            compute("phase_constants"));
    return text + fmt::format("if constexpr (!std::is_same_v<Number, Real>) {{\n"
                              "                    {};\n                }}\n"
                              "                const auto& known = constants(course);\n",
                              compute(plan_.rate_constants()));
}

// The type of the constants that are not in Real.
std::string CppCourse::own_constants() const {
    if (plan_.main_rates_read_some())
        return "std::conditional_t<resonform::divides_rates<Number, Real>, PhaseConstants<Number>, "
               "Constants<Number>>";
    return fmt::format("{}<Number>", plan_.rate_constants_type());
}

std::string CppCourse::arguments() const {
    std::string text;
    if (!plan_.levels.empty()) text += "        a.tables = point.tables;\n";
    for (std::size_t k = 0; k < program_.phases.size(); ++k)
        text += fmt::format(
            fmt::runtime(
                program_.phases[k].decays()
                    ? "        a.exp_{0} = point.power[{1}];\n"
                    : "        a.cos_{0} = point.cosine[{1}];\n        a.sin_{0} = point.sine[{1}];\n"),
            plan_.phase_names[k], k);
    return text;
}

std::string CppCourse::print() const {
    std::vector<std::size_t> levels;
    for (const CppLevel& level : plan_.levels) levels.push_back(level.members.size());
    std::vector<bool> decays;
    std::vector<std::uint64_t> fades;
    for (std::size_t k = 0; k < program_.phases.size(); ++k) {
        decays.push_back(program_.phases[k].decays());
        fades.push_back(0);
        for (const std::size_t with : plan_.fades_with(k)) fades.back() |= std::uint64_t(1) << with;
    }
    const bool nested = plan_.levels.size() > 1 || plan_.rounded_phases() || !program_.flow.empty();
    const bool steady = levels.empty() && program_.data.empty() &&
                        std::none_of(plan_.phase_rates.begin(), plan_.phase_rates.end(),
                                     [this](StraightLine::Value v) { return plan_.code.at(v).varying; });
    const bool no_data = program_.data.empty(), no_callables = plan_.callables.empty();
    return filled(
        frames::course,
        {{"flow", program_.flow.empty() ? "false" : "true"},
         {"nested", nested ? "true" : "false"},
         {"steady", steady ? "true" : "false"},
         {"level_count", std::to_string(levels.size())},
         {"levels", fmt::format("{}", fmt::join(levels, ", "))},
         {"columns", std::to_string(plan_.columns_before(levels.size()))},
         {"phases", std::to_string(program_.phases.size())},
         {"rounded", fmt::format("{}", fmt::join(plan_.phase_uses_tables, ", "))},
         {"decays", fmt::format("{}", fmt::join(decays, ", "))},
         {"fades", fmt::format("{}", fmt::join(fades, ", "))},
         {"start", plan_.member_list(plan_.flow_starts, "c.")},
         {"rates", rates()},
         {"margins", margins()},
         {"conditions", conditions()},
         {"packs", !plan_.loses_digits && no_data && no_callables ? "true" : "false"},
         {"own", own_constants()},
         {"constants", constants()},
         {"edges", no_data ? "" : "            decltype(Evaluator::edges(own)) edges;\n"},
         {"find_edges", no_data ? "" : "                edges = Evaluator::edges(known);\n"},
         {"starts", plan_.member_list(plan_.phase_starts, "known.")},
         {"phase_rates", phase_rates()},
         {"divided", divided_rates()},
         {"arguments", arguments()},
         {"precise", !plan_.loses_digits ? ""
                                         : "        if (status == Status::ok && !precise(c, a)) return "
                                           "Status::low_precision;\n"}});
}

} // namespace

std::string cpp_at_end(const CppPlan& plan) {
    const bool flow = !plan.program->flow.empty();
    const std::vector<std::string> none(plan.outputs.size(), "none");
    return filled(frames::at_end,
                  {{"unless", flow ? ", unless\n    // the flow leaves its domain or hardly resolves" : ""},
                   {"kept", flow ? "" : "const "},
                   {"otherwise", flow ? std::string(frames::by_tables) : ""},
                   {"none", fmt::format("{}", fmt::join(none, ", "))}});
}

std::string cpp_course(const CppPlan& plan) { return CppCourse(plan).print(); }

} // namespace resonform
