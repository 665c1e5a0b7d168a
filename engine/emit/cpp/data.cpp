// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/data.hpp"

#include "emit/cpp/function.hpp"
#include "emit/cpp/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace resonform {

namespace {

constexpr std::size_t numbers_of_a_line = 6;

std::string array(const std::string& name, const std::vector<double>& numbers) {
    std::string text = fmt::format("inline constexpr std::array<double, {}> {}{{", numbers.size(), name);
    for (std::size_t k = 0; k < numbers.size(); ++k)
        text +=
            fmt::format("{}{}{}", k == 0 ? "" : ",", k % numbers_of_a_line == 0 ? "\n    " : " ", numbers[k]);
    return text + "};\n";
}

std::size_t edge_count(const Program& program) {
    std::size_t count = 0;
    for (const ProgramData& data : program.data) count += data.samples->breakpoints.size();
    return count;
}

} // namespace

std::string cpp_data_name(const PiecewisePolynomial& data) { return "data_" + data.name; }

std::string cpp_data_tables(const Program& program) {
    std::map<std::string, DataPointer> all;
    for (std::size_t n = 0; n < program.graph.size(); ++n)
        if (const Graph::Entry& e = program.graph.at(static_cast<Graph::Node>(n)); e.data != nullptr)
            all.emplace(cpp_data_name(*e.data), e.data);
    std::string text;
    for (const auto& [name, data] : all)
        text += array(name + "_breakpoints", data->breakpoints) +
                array(name + "_coefficients", data->coefficients) +
                fmt::format("inline constexpr resonform::Spline {0}{{{0}_breakpoints.data(), "
                            "{0}_coefficients.data(), {1}, {2}}};\n\n",
                            name, data->pieces(), data->degree);
    return text;
}

std::string cpp_data_edges(CppPlan& plan) {
    const Program& program = *plan.program;
    if (program.data.empty()) return "";
    CppFunction function(plan.code, "Number", "q", plan.lies);
    for (const auto& [value, name] : plan.members) function.know(value, "c." + name);
    function.know(plan.code.lower(program.slow_time), "T");
    function.compute(plan.data_arguments, false);
    std::vector<std::string> texts;
    for (const StraightLine::Value v : plan.data_arguments)
        texts.push_back("Number(" + function.text(v) + ")");
    const std::string arguments = fmt::format("std::array<Number, {}>", texts.size());
    const std::string edges = fmt::format("std::array<Number, {}>", edge_count(program));
    std::string text = "    // What the data stand at.\n" +
                       function.print({"template <class Number> static",
                                       arguments,
                                       "data_arguments",
                                       {{"const Constants<Number>&", "c"}, {"const Number&", "T"}},
                                       {},
                                       {fmt::format("return {{{}}};", fmt::join(texts, ", "))}}) +
                       "\n    // The slow times at which pieces of data end.\n"
                       "    template <class Number> static " +
                       edges + " edges(const Constants<Number>& c) {\n        " + edges +
                       " all;\n        std::size_t next = 0;\n        const " + arguments +
                       " at_0 = data_arguments(c, Number(0)), at_1 = data_arguments(c, Number(1));\n";
    for (std::size_t k = 0; k < program.data.size(); ++k)
        text += fmt::format("        resonform::add_edges({}, at_0[{}], at_1[{}], all, next);\n",
                            cpp_data_name(*program.data[k].samples), k, k);
    return text + "        return all;\n    }\n\n";
}

std::string cpp_in_pieces(const CppPlan& plan, const std::string& function, const std::string& constants) {
    if (plan.program->data.empty()) return function;
    return fmt::format("resonform::in_pieces({}, edges({}))", function, constants);
}

} // namespace resonform
