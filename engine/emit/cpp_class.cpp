// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp_class.hpp"

#include "emit/cpp_interface.hpp"
#include "emit/cpp_plan.hpp"
#include "emit/cpp_stages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace resonform {

namespace {

class CppFrame {
public:
    explicit CppFrame(const CppPlan& plan) : program_(*plan.program), plan_(plan) {}

    std::string print() const {
        return aliases() + look_up() + widened() + prepare() + construct() + data_members();
    }

private:
    std::string aliases() const;
    std::string look_up() const;
    std::string widened() const;
    std::string prepare() const;
    std::string flow_starts() const;
    std::string layers() const;
    std::string construct() const;
    std::string data_members() const;

    const Program& program_;
    const CppPlan& plan_;
};

std::string CppFrame::aliases() const {
    std::string text = "    using Interval = resonform::Interval<Real>;\n";
    if (!program_.phases.empty()) text += "    using Wide = typename resonform::Phase<Real>::Wide;\n";
    return text + "\n";
}

// Tables are kept in Real; a phase that needs them takes them as they are.
std::string CppFrame::widened() const {
    if (std::none_of(plan_.phase_uses_tables.begin(), plan_.phase_uses_tables.end(),
                     [](bool uses) { return uses; }))
        return "";
    return fmt::format(R"(    static std::array<Wide, {0}> widened(const std::array<Real, {0}>& values) {{
        std::array<Wide, {0}> wide;
        for (std::size_t k = 0; k < values.size(); ++k) wide[k] = Wide(values[k]);
        return wide;
    }}

)",
                       plan_.columns_before(plan_.levels.size()));
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
        text += fmt::format("        const auto before = look_up_{0}(T);\n        const auto own = "
                            "tables_{0}_(T);\n        {1} all;\n"
                            "        std::copy(before.begin(), before.end(), all.begin());\n"
                            "        std::copy(own.begin(), own.end(), all.begin() + before.size());\n       "
                            " return all;\n    }}\n\n",
                            level - 1, type);
    }
    return text;
}

std::string CppFrame::prepare() const {
    std::string text = "    // What the call needs beside the constants.\n"
                       "    Status prepare(const Real& t, Arguments& a) const noexcept {\n"
                       "        if (status_ != Status::ok) return status_;\n";
    if (plan_.levels.empty() && program_.phases.empty())
        return text + "        return interval_.locate(t, a.T);\n    }\n\n";
    text += "        if (const Status located = interval_.locate(t, a.T); located != Status::ok) return "
            "located;\n";
    if (!plan_.levels.empty())
        text += fmt::format("        a.tables = look_up_{}(a.T);\n", plan_.levels.size());
    if (program_.phases.empty()) return text + "        return Status::ok;\n    }\n\n";
    text += "        Status status = Status::ok;\n";
    for (const std::string& name : plan_.phase_names)
        text += fmt::format("        if (const Status seen = {0}_(t, a.cos_{0}, a.sin_{0}); seen != "
                            "Status::ok) status = seen;\n",
                            name);
    return text + "        return status;\n    }\n\n";
}

// Builds a table as far as it goes; what goes nowhere is the answer of the construction.
std::string built_or_return(const std::string& call) {
    return fmt::format(R"(        if (const Status built = interval_.shorten(
                {}, reach);
            built != Status::ok)
            return built;
)",
                       call);
}

std::string CppFrame::flow_starts() const {
    std::vector<std::string> list;
    for (const StraightLine::Value v : plan_.flow_starts) list.push_back("c_." + plan_.members.at(v));
    return fmt::format("{}", fmt::join(list, ", "));
}

std::string CppFrame::layers() const {
    if (plan_.layers.empty()) return "";
    return built_or_return(
        fmt::format("resonform::clear_of_layers([this](const Real& T) {{ return layers(c_, T{}); }}, reach)",
                    plan_.layers_use_flow ? ", look_up_1(T)" : ""));
}

std::string CppFrame::construct() const {
    std::string text =
        "    Status construct(const Real& eps, const Parameters& parameters, const Start& start,\n"
        "                     const Real& end) {\n"
        "        if (!Interval::accepts(eps, end)) return Status::bad_argument;\n";
    for (const std::string& name : plan_.parameters)
        text += fmt::format("        if (!finite(parameters.{})) return Status::bad_argument;\n", name);
    for (const std::string& name : plan_.start)
        text += fmt::format("        if (!finite(start.{})) return Status::bad_argument;\n", name);
    text +=
        "        interval_ = Interval(eps, end);\n        compute_constants(eps, parameters, start, c_);\n";
    for (const StraightLine::Value condition : plan_.constant_conditions)
        text += fmt::format("        if (!(c_.{} > Real(0))) return Status::outside_domain;\n",
                            plan_.members.at(condition));
    if (!plan_.levels.empty() || !program_.phases.empty() || !plan_.layers.empty())
        text += "        Real reach = end; // less where the domain ends before\n";
    if (program_.flow.empty()) text += layers();
    for (std::size_t level = 0; level < plan_.levels.size(); ++level) {
        if (plan_.levels[level].flow) {
            text += built_or_return(fmt::format(
                "tables_{}_.build([this](const Real& T, const std::array<Real, {}>& flow) {{ return "
                "flow_rates(c_, T, flow); }},\n                              {{{}}}, reach)",
                level, program_.flow.size(), flow_starts()));
            text += layers();
            continue;
        }
        const std::string tables = level == 0 ? "" : fmt::format(", look_up_{}(T)", level);
        text += built_or_return(fmt::format(
            "tables_{0}_.build([this](const Real& T) {{ return integrands_{0}(c_, T{1}); }}, reach)", level,
            tables));
    }
    if (!program_.phases.empty())
        text += "        Constants<Wide> wide;\n        compute_constants(eps, parameters, start, wide);\n";
    for (std::size_t k = 0; k < program_.phases.size(); ++k) {
        const std::string& name = plan_.phase_names[k];
        std::string rate = fmt::format("{}_rate(wide, T)", name);
        if (plan_.phase_uses_tables[k])
            rate = fmt::format("{}_rate(wide, T, widened(look_up_{}(static_cast<Real>(T))))", name,
                               plan_.levels.size());
        text += fmt::format(
            "        const auto {}_rates = [&](const Wide& T) {{ return std::array<Wide, 1>{{{}}}; }};\n",
            name, rate);
        text += built_or_return(fmt::format("{0}_.build({0}_rates, wide.{1}, eps, reach{2})", name,
                                            plan_.members.at(plan_.phase_starts[k]),
                                            plan_.phase_uses_tables[k] ? ", true" : ""));
    }
    return text + "        return Status::ok;\n    }\n\n";
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
    for (const std::string& name : plan_.phase_names)
        text += fmt::format("    resonform::Phase<Real> {}_;\n", name);
    return "    Constants<Real> c_;\n    Interval interval_;\n" + text + "    Status status_ = Status::ok;\n";
}

} // namespace

std::string cpp_class(const Program& program) {
    CppPlan plan(program);
    return "template <class Real = double> class Evaluator {\npublic:\n    using Status = "
           "resonform::Status;\n\n" +
           cpp_interface(plan) + "private:\n" + cpp_stages(plan) + CppFrame(plan).print() + "};\n";
}

} // namespace resonform
