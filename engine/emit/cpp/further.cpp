// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/further.hpp"

#include "emit/cpp/embedded_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace resonform {

namespace {

std::string name_of(const PlannedFurther& further) { return namespace_of_further(*further.plan.program); }

// plan: of the program, whose class has all callables.
std::string class_of(const PlannedFurther& further, const CppPlan& plan) {
    std::string types;
    for (const CppCallable& called : further.plan.callables)
        for (const CppCallable& given : plan.callables)
            if (given.function == called.function) types += ", " + given.type;
    return fmt::format("{}::Evaluator<Real{}>", name_of(further), types);
}

// "own.g = parameters.g;" for what both have; how many they are.
struct Copied {
    std::string text;
    std::size_t count = 0;
};
Copied copied(const std::vector<ProgramInput>& to, const std::vector<std::string>& to_fields,
              const std::vector<ProgramInput>& from, const std::vector<std::string>& from_fields,
              const std::string& source) {
    Copied all;
    for (std::size_t k = 0; k < to.size(); ++k) {
        const auto same = std::find_if(from.begin(), from.end(),
                                       [&](const ProgramInput& input) { return input.name == to[k].name; });
        if (same == from.end()) continue;
        const auto at = static_cast<std::size_t>(same - from.begin());
        all.text += fmt::format("        own.{} = {}.{};\n", to_fields[k], source, from_fields[at]);
        ++all.count;
    }
    return all;
}

std::string arguments_of(const PlannedFurther& further, const CppPlan& plan) {
    const CppPlan& own = further.plan;
    const Program &to = *own.program, &from = *plan.program;
    const std::string type = class_of(further, plan);
    Copied parameters = copied(to.parameters, own.parameters, from.parameters, plan.parameters, "parameters");
    for (const CppCallable& callable : own.callables)
        parameters.text += fmt::format("        own.{0} = parameters.{0};\n", callable.name);
    const Copied start = copied(to.start, own.start, from.start, plan.start, "start");
    const bool complete = start.count == to.start.size();
    return filled(frames::further, {{"name", name_of(further)},
                                    {"class", type},
                                    {"parameters", parameters.text},
                                    {"begin", complete ? ""
                                                       : " = " + type + "::default_start(eps, " +
                                                             name_of(further) + "_parameters(parameters))"},
                                    {"start", start.text}});
}

} // namespace

std::vector<PlannedFurther> planned(const std::vector<CppFurther>& further) {
    std::vector<PlannedFurther> list;
    list.reserve(further.size());
    for (const CppFurther& f : further) list.push_back({f.outputs, CppPlan(*f.program)});
    return list;
}

std::vector<CppCallable> callables_of(const std::vector<PlannedFurther>& further) {
    std::vector<CppCallable> list;
    for (const PlannedFurther& f : further)
        list.insert(list.end(), f.plan.callables.begin(), f.plan.callables.end());
    return list;
}

namespace {

// The order as a part of a name: 5, 7_2.
std::string order_in_names(const Program& program) {
    const Rational order = program.weight(program.order);
    const std::string above = to_string(cln::numerator(order)), below = to_string(cln::denominator(order));
    return below == "1" ? above : above + "_" + below;
}

} // namespace

std::string namespace_of_further(const Program& program) { return "next_" + order_in_names(program); }

std::string cpp_estimates(const CppPlan& plan, const std::vector<PlannedFurther>& further) {
    if (further.empty()) return "";
    std::string calls;
    std::vector<std::string> errors(plan.outputs.size(), "none");
    for (const PlannedFurther& f : further) {
        const std::string values = "of_" + order_in_names(*f.plan.program);
        calls += fmt::format("        typename {}::Values {};\n        status = resonform::worse(status, "
                             "{}_(t, {}));\n",
                             class_of(f, plan), values, name_of(f), values);
        for (std::size_t k = 0; k < f.outputs.size(); ++k)
            errors[f.outputs[k]] = fmt::format("resonform::math::magnitude(Real({}.{} - values.{}))", values,
                                               f.plan.outputs[k].name, plan.outputs[f.outputs[k]].name);
    }
    const std::vector<std::string> names = plan.output_arrays(), none(plan.outputs.size(), "none");
    return filled(frames::estimates, {{"calls", calls},
                                      {"none", fmt::format("{}", fmt::join(none, ", "))},
                                      {"errors", fmt::format("{}", fmt::join(errors, ", "))},
                                      {"arrays", fmt::format("Real* {}", fmt::join(names, ", Real* "))},
                                      {"names", fmt::format("{}", fmt::join(names, ", "))}});
}

std::string cpp_further_arguments(const CppPlan& plan, const std::vector<PlannedFurther>& further) {
    if (further.empty()) return "";
    std::string text(frames::errors);
    for (const PlannedFurther& f : further) text += arguments_of(f, plan);
    return text;
}

std::string cpp_further_members(const CppPlan& plan, const std::vector<PlannedFurther>& further) {
    std::string text;
    for (const PlannedFurther& f : further)
        text += fmt::format("    {} {}_;\n", class_of(f, plan), name_of(f));
    return text;
}

std::string cpp_further_built(const std::vector<PlannedFurther>& further) {
    std::string text;
    for (const PlannedFurther& f : further)
        text += fmt::format("{0}_(eps, {0}_parameters(parameters), {0}_start(eps, parameters, start), "
                            "slow_time_end),\n          ",
                            name_of(f));
    return text;
}

} // namespace resonform
