// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/constants.hpp"

#include "emit/cpp/digits.hpp"
#include "emit/cpp/embedded_text.hpp"
#include "emit/cpp/function.hpp"
#include "emit/cpp/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>

namespace resonform {

namespace {

using Value = StraightLine::Value;

class CppConstants {
public:
    explicit CppConstants(CppPlan& plan) : program_(*plan.program), plan_(plan) {}

    // What the conditions use is lowered before.
    std::string print() {
        std::string text = constants();
        text += kept_constants() + phase_constants() + start_conditions();
        return differences() + text;
    }

private:
    void know_arguments(CppFunction& function);
    static CppFunction::Frame from_arguments(const std::string& result, const std::string& name,
                                             const std::string& target,
                                             const std::vector<std::string>& last = {});
    [[nodiscard]] std::string differences() const;
    std::string constants();
    std::string kept_constants() const;
    std::vector<std::string> kept_lines() const;
    std::string required_positive() const;
    std::string phase_constants();
    std::string start_conditions();

    const Program& program_;
    CppPlan& plan_;
    static constexpr const char* constants_name = "compute_constants";
    std::optional<CppFunction> walked_; // compute_constants, if a loop walks it
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
CppFunction::Frame CppConstants::from_arguments(const std::string& result, const std::string& name,
                                                const std::string& target,
                                                const std::vector<std::string>& last) {
    CppFunction::Frame frame{
        "template <class Number> static",
        result,
        name,
        {{"const Real&", "given_eps"}, {"const Parameters&", "parameters"}, {"const Start&", "start"}},
        {},
        last};
    if (!target.empty()) frame.parameters.emplace_back(target, "c");
    return frame;
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
        if (plan_.lies == nullptr) function.walk(plan_.phase_constants); // lies are planted in statements
    }
    function.compute(roots, true);
    if (function.is_walked()) walked_ = function;
    for (const CppCallable& callable : plan_.callables)
        function.begin_with("c." + callable.name, "parameters." + callable.name);
    return text + "    };\n\n" +
           function.print(from_arguments("void", constants_name, "Constants<Number>&")) + "\n";
}

// One a constant, but elements of the array have one together.
std::vector<std::string> CppConstants::kept_lines() const {
    constexpr std::ptrdiff_t longest_run = digit_base - 1;
    std::vector<std::string> lines, readers;
    std::map<Value, std::size_t> listed; // and the places of their readers
    for (const auto& [value, reader] : plan_.kept) {
        if (!std::binary_search(plan_.listed.begin(), plan_.listed.end(), value)) {
            lines.push_back(fmt::format("        keep(from.{0}, c.{0}, {1});\n", plan_.members.at(value),
                                        cpp_literal(reader)));
            continue;
        }
        auto known = std::find(readers.begin(), readers.end(), reader);
        listed[value] = static_cast<std::size_t>(known - readers.begin());
        if (known == readers.end()) readers.push_back(reader);
    }
    if (listed.empty()) return lines;
    std::string runs;
    for (auto v = plan_.listed.begin(); v != plan_.listed.end();) {
        const auto reader = [&](Value value) {
            const auto found = listed.find(value);
            return found == listed.end() ? readers.size() : found->second;
        };
        const auto end =
            std::find_if(v, v + std::min<std::ptrdiff_t>(plan_.listed.end() - v, longest_run),
                         [&, first = reader(*v)](Value value) { return reader(value) != first; });
        runs += in_digits(reader(*v), 2) + digit(static_cast<std::size_t>(end - v));
        v = end;
    }
    for (std::string& reader : readers) reader = cpp_literal(reader);
    lines.push_back(fmt::format("        keep(from.{0}, c.{0}, std::array{{{1}}},\n{2});\n", plan_.list_name,
                                fmt::join(readers, ", "), literal_lines(runs)));
    return lines;
}

// Those that are elements of the array one after the other take one call.
std::string CppConstants::required_positive() const {
    constexpr std::size_t many = 4;
    const std::vector<CppCondition>& conditions = plan_.constant_conditions;
    std::string text;
    for (std::size_t k = 0, next = 0; k < conditions.size(); k = next) {
        const auto listed = std::lower_bound(plan_.listed.begin(), plan_.listed.end(), conditions[k].value);
        next = k;
        for (auto v = listed;
             v != plan_.listed.end() && next < conditions.size() && *v == conditions[next].value; ++v)
            ++next;
        if (next < k + many) {
            text += fmt::format("        if (!(from.{} > From(0))) return {{Status::outside_domain, {}}};\n",
                                plan_.members.at(conditions[k].value), cpp_literal(conditions[k].quantity));
            next = k + 1;
            continue;
        }
        std::vector<std::string> names;
        for (std::size_t j = k; j < next; ++j) names.push_back(cpp_literal(conditions[j].quantity));
        text += fmt::format(
            "        if (const Cause bad = resonform::first_not_positive(from.{}, {}, std::array{{\n"
            "                {}}}); bad.status != Status::ok) return bad;\n",
            plan_.list_name, listed - plan_.listed.begin(), fmt::join(names, ",\n                "));
    }
    return text;
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
    text += "    // What has no place in Number is the answer.\n" + head("Cause", "keep", "") +
            required_positive();
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
    CppFunction::Frame frame = from_arguments("void", "compute_phase_constants", "PhaseConstants<Number>&");
    for (const Value v : plan_.phase_constants) {
        const std::string& name = plan_.members.at(v);
        fields += fmt::format("        Number {};\n", name);
        copies += fmt::format("            c.{0} = all.{0};\n", name);
        function.assign(v, "c." + name);
        if (walked_) frame.last.push_back(fmt::format("c.{} = {};", name, walked_->text(v)));
    }
    if (!walked_) function.compute(plan_.phase_constants, true);
    return "    // Those that phases need in more digits than Real has.\n"
           "    template <class Number> struct PhaseConstants {\n" +
           fields + "    };\n\n" +
           (walked_ ? walked_->print_first(frame, constants_name) : function.print(frame)) + "\n" +
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
           function.print(from_arguments(fmt::format("std::array<Number, {}>", texts.size()),
                                         "start_conditions", "",
                                         {fmt::format("return {{{}}};", fmt::join(texts, ", "))})) +
           "\n";
}

} // namespace

std::string cpp_constants(CppPlan& plan) { return CppConstants(plan).print(); }

} // namespace resonform
