// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/constants.hpp"

#include "emit/cpp/embedded_text.hpp"
#include "emit/cpp/function.hpp"
#include "emit/cpp/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace resonform {

namespace {

using Value = StraightLine::Value;

class CppConstants {
public:
    explicit CppConstants(CppPlan& plan) : program_(*plan.program), plan_(plan) {}

    // What the conditions use is lowered before.
    std::string print() {
        const std::string text = constants() + kept_constants() + phase_constants() + start_conditions();
        return differences() + text;
    }

private:
    void know_arguments(CppFunction& function);
    static std::string from_arguments(const CppFunction& function, const std::string& result,
                                      const std::string& name, const std::string& target,
                                      const std::vector<std::string>& last = {});
    [[nodiscard]] std::string differences() const;
    std::string constants();
    std::string kept_constants() const;
    std::vector<std::string> kept_lines() const;
    std::string phase_constants();
    std::string start_conditions();

    const Program& program_;
    CppPlan& plan_;
};

void CppConstants::know_arguments(CppFunction& function) {
    function.define(plan_.code.lower(program_.eps), "eps", "Number(given_eps)");
    for (std::size_t k = 0; k < program_.parameters.size(); ++k)
        function.define(plan_.code.lower(program_.parameters[k].symbol), program_.parameters[k].name,
                        "Number(parameters." + plan_.parameters[k] + ")");
    for (std::size_t k = 0; k < program_.start.size(); ++k)
        function.define(plan_.code.lower(program_.start[k].symbol), program_.start[k].name,
                        "Number(start." + plan_.start[k] + ")");
}

// `result name(arguments, target c)`, without a c if there is no target.
std::string CppConstants::from_arguments(const CppFunction& function, const std::string& result,
                                         const std::string& name, const std::string& target,
                                         const std::vector<std::string>& last) {
    CppFunction::Frame frame{
        "template <class Number> static",
        result,
        name,
        {{"const Real&", "given_eps"}, {"const Parameters&", "parameters"}, {"const Start&", "start"}},
        {},
        last};
    if (!target.empty()) frame.parameters.emplace_back(target, "c");
    return function.print(frame) + "\n";
}

// Differences of start values and where a state rests, in the type that is asked for.
std::string CppConstants::differences() const {
    std::string text;
    const std::map<Graph::Node, std::string> inputs = plan_.input_names();
    for (const auto& [v, symbols] : plan_.code.doubled()) {
        CppFunction function(plan_.code, "Number", "q", plan_.lies);
        std::vector<std::pair<std::string, std::string>> parameters;
        for (const Value symbol : symbols) {
            const std::string& wish = inputs.at(plan_.code.at(symbol).symbol);
            parameters.emplace_back("const Number&", function.know_as(symbol, wish));
        }
        const Value difference = plan_.code.at(v).operands.front();
        function.compute({difference}, true);
        text += function.print({"template <class Number> static",
                                "Number",
                                cpp_difference_name(plan_.code, v),
                                parameters,
                                {},
                                {fmt::format("return Number({});", function.text(difference))}}) +
                "\n";
    }
    if (text.empty()) return "";
    return "    // How far the start is from where a state rests, in Number: of twice the digits, for they "
           "cancel.\n" +
           text;
}

std::string CppConstants::constants() {
    std::string text = "    // What is computed once.\n    template <class Number> struct Constants {\n";
    CppFunction function(plan_.code, "Number", "k", plan_.lies);
    know_arguments(function);
    std::vector<Value> roots;
    for (const CppCallable& callable : plan_.callables)
        text += fmt::format("        resonform::Callable<{}> {};\n", callable.type, callable.name);
    for (const auto& [value, name] : plan_.members) {
        roots.push_back(value);
        if (std::binary_search(plan_.listed.begin(), plan_.listed.end(), value)) continue;
        text += fmt::format("        Number {};\n", name);
        function.assign(value, "c." + name);
    }
    if (plan_.walks_constants()) {
        text += fmt::format("        std::array<Number, {}> {};\n", plan_.listed.size(), plan_.list_name);
        function.assign(plan_.listed, fmt::format("c.{}", plan_.list_name));
        if (plan_.lies == nullptr) function.walk(); // lies are planted in statements
    }
    function.compute(roots, true);
    for (const CppCallable& callable : plan_.callables)
        function.begin_with("c." + callable.name, "parameters." + callable.name);
    return text + "    };\n\n" + from_arguments(function, "void", "compute_constants", "Constants<Number>&");
}

// One a constant; elements of the array that are named alike have one together.
std::vector<std::string> CppConstants::kept_lines() const {
    std::vector<std::string> lines;
    for (std::size_t k = 0, next = 0; k < plan_.kept.size(); k = next) {
        const auto& [value, reader] = plan_.kept[k];
        next = k + 1;
        const auto place = std::lower_bound(plan_.listed.begin(), plan_.listed.end(), value);
        if (place == plan_.listed.end() || *place != value) {
            lines.push_back(fmt::format("        keep(from.{0}, c.{0}, {1});\n", plan_.members.at(value),
                                        cpp_literal(reader)));
            continue;
        }
        auto end = place + 1;
        for (; next < plan_.kept.size() && end != plan_.listed.end() &&
               plan_.kept[next] == std::pair{*end, reader};
             ++next)
            ++end;
        lines.push_back(fmt::format("        keep(from.{0}, c.{0}, {1}, {2}, {3});\n", plan_.list_name,
                                    place - plan_.listed.begin(), end - plan_.listed.begin(),
                                    cpp_literal(reader)));
    }
    return lines;
}

// For powers of arguments that may leave the range of Number: where they do, all constants are computed in
// Scaled, then converted to Number.
std::string CppConstants::kept_constants() const {
    if (plan_.range.native) return "";
    constexpr std::size_t longest = 200; // statements of a function
    const auto head = [](const std::string& result, const std::string& name, const std::string& last) {
        return fmt::format(
            "    template <class From, class Number> static {} {}(const Constants<From>& from, "
            "Constants<Number>& c{}) {{\n",
            result, name, last);
    };
    std::string text, calls;
    const std::vector<std::string> lines = kept_lines();
    for (std::size_t k = 0; k < lines.size(); k += longest) {
        const std::string name = fmt::format("keep_{}", k / longest + 1);
        text += head("void", name, ", resonform::Keeper& keep");
        for (std::size_t j = k; j < std::min(k + longest, lines.size()); ++j) text += lines[j];
        text += "    }\n\n";
        calls += fmt::format("        {}(from, c, keep);\n", name);
    }
    text += "    // What has no place in Number is the answer.\n" + head("Cause", "keep", "");
    for (const CppCondition& condition : plan_.constant_conditions)
        text += fmt::format("        if (!(from.{} > From(0))) return {{Status::outside_domain, {}}};\n",
                            plan_.members.at(condition.value), cpp_literal(condition.quantity));
    for (const CppCallable& callable : plan_.callables)
        text += fmt::format("        c.{0} = from.{0};\n", callable.name);
    return text + "        resonform::Keeper keep;\n" + calls + "        return keep.cause;\n    }\n\n" +
           filled(frames::keep_constants,
                  {{"finely", plan_.fine_constants ? std::string(frames::keep_finely) : ""}});
}

// Those of them that phases read in more digits than Real has.
std::string CppConstants::phase_constants() {
    if (plan_.phase_constants.empty()) return "";
    CppFunction function(plan_.code, "Number", "k", plan_.lies);
    know_arguments(function);
    std::string fields, copies;
    for (const Value v : plan_.phase_constants) {
        const std::string& name = plan_.members.at(v);
        fields += fmt::format("        Number {};\n", name);
        copies += fmt::format("            c.{0} = all.{0};\n", name);
        function.assign(v, "c." + name);
    }
    function.compute(plan_.phase_constants, true);
    return "    // Those that phases need in more digits than Real has.\n"
           "    template <class Number> struct PhaseConstants {\n" +
           fields + "    };\n\n" +
           from_arguments(function, "void", "compute_phase_constants", "PhaseConstants<Number>&") +
           (plan_.range.native ? "" : filled(frames::keep_phase_constants, {{"copies", copies}}));
}

// Conditions on the start: products of many arguments, of which only the sign matters.
std::string CppConstants::start_conditions() {
    if (!plan_.conditions_apart) return "";
    CppFunction function(plan_.code, "Number", "k", plan_.lies);
    know_arguments(function);
    function.call_through("parameters");
    std::vector<Value> conditions;
    for (const CppCondition& condition : plan_.constant_conditions) conditions.push_back(condition.value);
    if (plan_.walks_constants() && plan_.lies == nullptr) function.walk();
    function.compute(conditions, true);
    std::vector<std::string> texts;
    for (const Value condition : conditions) texts.push_back("Number(" + function.text(condition) + ")");
    return "    // All > 0, or the solution does not start where its map is close to the identity.\n" +
           from_arguments(function, fmt::format("std::array<Number, {}>", texts.size()), "start_conditions",
                          "", {fmt::format("return {{{}}};", fmt::join(texts, ", "))});
}

} // namespace

std::string cpp_constants(CppPlan& plan) { return CppConstants(plan).print(); }

} // namespace resonform
