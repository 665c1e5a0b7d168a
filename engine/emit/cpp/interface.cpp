// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/interface.hpp"

#include "emit/cpp/embedded_text.hpp"
#include "emit/cpp/final_point.hpp"
#include "emit/cpp/function.hpp"
#include "emit/cpp/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <tuple>

namespace resonform {

namespace {

using Value = StraightLine::Value;

class CppInterface {
public:
    CppInterface(CppPlan& plan, const std::vector<PlannedFurther>& further)
        : program_(*plan.program), plan_(plan), further_(further) {}

    std::string print() {
        return parameters() + start() + results("Values", plan_.outputs, "The outputs at one time.") +
               results("State", plan_.state, "All states at one time, with the map at its full weight.") +
               filled(frames::constructors, {{"further", cpp_further_built(further_)}}) + called() + why() +
               default_start() + default_slow_time_end() + calls() + cpp_estimates(plan_, further_);
    }

private:
    std::string parameters();
    std::string start() const;
    static std::string results(const std::string& name, const std::vector<CppResult>& list,
                               const std::string& comment);
    std::string called() const;
    std::string why() const;
    std::string default_start();
    std::string default_slow_time_end();
    std::string calls() const;
    std::string batch() const;
    std::string ensemble() const;
    [[nodiscard]] std::string default_type() const;
    [[nodiscard]] std::string default_text(const CppFunction& function, Value v) const;
    void know_inputs(CppFunction& function);

    const Program& program_;
    CppPlan& plan_;
    const std::vector<PlannedFurther>& further_;
};

std::string CppInterface::parameters() {
    std::string text = "    // Parameters that are not fixed.\n    struct Parameters {\n";
    for (std::size_t k = 0; k < program_.parameters.size(); ++k) {
        const ProgramInput& input = program_.parameters[k];
        std::string value = "resonform::math::not_a_number<Real>()"; // to be given
        if (input.default_value >= 0) {
            CppFunction function(plan_.code, "Real", "q");
            const Value v = plan_.code.lower(input.default_value);
            function.compute({v}, true);
            value = function.text(v);
        }
        text += fmt::format("        Real {} = {};\n", plan_.parameters[k], value);
    }
    for (const CppCallable& callable : plan_.callables)
        text += fmt::format(
            "        resonform::Callable<{}> {}; // to be given: {} and its derivatives, 0 ... {}\n",
            callable.type, callable.name, callable.function, callable.derivatives);
    return text + "    };\n\n";
}

std::string CppInterface::start() const {
    std::string text = "    // Start values and constants of the solution.\n    struct Start {\n";
    for (std::size_t k = 0; k < program_.start.size(); ++k)
        text += fmt::format("        Real {}{{}}; // {}\n", plan_.start[k], program_.start[k].meaning);
    return text + "    };\n\n";
}

std::string CppInterface::results(const std::string& name, const std::vector<CppResult>& list,
                                  const std::string& comment) {
    if (list.empty()) return "";
    std::string text = fmt::format("    // {}\n    struct {} {{\n", comment, name);
    for (const CppResult& result : list) text += fmt::format("        Real {}{{}};\n", result.name);
    return text + "    };\n\n";
}

// Constructors and at_end whose last arguments are the callables.
std::string CppInterface::called() const {
    if (plan_.callables.empty()) return "";
    std::string given;
    for (const CppCallable& callable : plan_.callables)
        given += fmt::format("        parameters.{0} = {0};\n", callable.name);
    return filled(frames::called, {{"arguments", plan_.callable_list("const {type}& {name}")},
                                   {"names", plan_.callable_list("{name}")},
                                   {"given", given}});
}

std::string CppInterface::why() const {
    std::string phases;
    for (const bool fading : {false, true}) // these are seldom the reason
        for (std::size_t k = 0; k < program_.phases.size(); ++k)
            if (!program_.phases[k].decays() && program_.phases[k].fades_with.empty() != fading)
                phases += fmt::format("!{}_.precise() ? {} : ", plan_.phase_names[k],
                                      cpp_literal(plan_.phase_names[k]));
    const std::string otherwise = plan_.loses_digits ? plan_.phase_names[*plan_.loses_digits] : "";
    if (!phases.empty() || !otherwise.empty())
        phases = fmt::format("        if (status == Status::low_precision) return {}{};\n", phases,
                             cpp_literal(otherwise));
    return filled(frames::why, {{"phases", phases},
                                {"conditions", cpp_literal(plan_.conditions_text())},
                                {"results", cpp_literal(plan_.results_text())}});
}

std::string CppInterface::default_type() const {
    return plan_.native_defaults ? "Real" : "resonform::Scaled<Real>";
}

std::string CppInterface::default_text(const CppFunction& function, Value v) const {
    return plan_.native_defaults ? function.text(v)
                                 : fmt::format("{}({}).value()", default_type(), function.text(v));
}

void CppInterface::know_inputs(CppFunction& function) {
    function.call_through("parameters");
    const auto know = [&](Graph::Node symbol, const std::string& name) {
        function.know(plan_.code.lower(symbol),
                      plan_.native_defaults ? name : fmt::format("{}({})", default_type(), name));
    };
    know(program_.eps, "eps");
    for (std::size_t k = 0; k < program_.parameters.size(); ++k)
        know(program_.parameters[k].symbol, "parameters." + plan_.parameters[k]);
}

// The values of the scene.
std::string CppInterface::default_start() {
    CppFunction function(plan_.code, default_type(), "q");
    know_inputs(function);
    std::vector<Value> roots;
    CppFunction::Frame frame{"static",         "Start",
                             "default_start",  {{"const Real&", "eps"}, {"const Parameters&", "parameters"}},
                             {"Start start;"}, {}};
    for (const ProgramInput& input : program_.start) roots.push_back(plan_.code.lower(input.default_value));
    function.compute(roots, true);
    for (std::size_t k = 0; k < roots.size(); ++k)
        frame.last.push_back(fmt::format("start.{} = {};", plan_.start[k], default_text(function, roots[k])));
    frame.last.emplace_back("return start;");
    return function.print(frame) + "\n";
}

std::string CppInterface::default_slow_time_end() {
    CppFunction function(plan_.code, default_type(), "q");
    know_inputs(function);
    const Value v = plan_.code.lower(program_.slow_time_end);
    function.compute({v}, true);
    return function.print({"static",
                           "Real",
                           "default_slow_time_end",
                           {{"const Real&", "eps"}, {"const Parameters&", "parameters"}},
                           {},
                           {fmt::format("return {};", default_text(function, v))}}) +
           "\n";
}

std::string CppInterface::batch() const {
    const std::vector<std::string> names = plan_.output_arrays();
    const char* prepare = !program_.has_tables()
                              ? "        return cause_.status;\n"
                              : "        if (cause_.status != Status::ok) return cause_.status;\n"
                                "        if constexpr (std::is_same_v<Real, double>)\n"
                                "            if (prepare_tables() == Status::no_memory) return "
                                "Status::no_memory;\n"
                                "        return Status::ok;\n";
    return filled(frames::batch, {{"arrays", fmt::format("Real* {}", fmt::join(names, ", Real* "))},
                                  {"names", fmt::format("{}", fmt::join(names, ", "))},
                                  {"Points", program_.has_tables() ? "Tabulated" : "Points"},
                                  {"prepare", prepare}});
}

std::string CppInterface::ensemble() const {
    const std::vector<std::string> names = plan_.output_arrays();
    std::string fields;
    for (const std::string& array : cpp_argument_arrays(plan_))
        fields += fmt::format("        const Real* {} = nullptr;\n", array);
    const char* full_phase =
        plan_.has_full_phase()
            ? "        bool full_phase = true; // false: a phase may be off by 4e-13 radians\n"
            : "";
    const bool called = !plan_.callables.empty();
    const std::string callables = plan_.callable_list("{name}");
    const auto if_called = [&](const std::string& text) { return called ? text : std::string(); };
    return filled(
        frames::ensemble,
        {{"fields", fields},
         {"full_phase", full_phase},
         {"optional", called ? "" : " = nullptr"},
         {"callables", if_called(", " + plan_.callable_list("const {type}& {name}"))},
         {"types", if_called(", " + plan_.callable_list("{type}"))},
         {"members", called ? "Called{members, given(Parameters{}, " + callables + ")}" : "members"},
         {"called", if_called(std::string(frames::called_members))},
         {"arrays", fmt::format("Real* {}", fmt::join(names, ", Real* "))},
         {"names", fmt::format("{}", fmt::join(names, ", "))}});
}

std::string CppInterface::calls() const {
    std::string text = "    // Anything but ok and low_precision: the values are not numbers.\n"
                       "    Status operator()(const Real& t, Values& values) const noexcept { return at(t, "
                       "Real(0), values); }\n\n" +
                       cpp_at_end(plan_) + batch() + ensemble();
    if (plan_.state.empty()) return text;
    return text +
           "    Status state(const Real& t, State& values) const noexcept { return state_at(t, Real(0), "
           "values); }\n" +
           cpp_call("state_at", "State", "states", plan_.state);
}

} // namespace

std::vector<std::string> cpp_argument_arrays(const CppPlan& plan) {
    CppNames names;
    names.unique("full_phase");
    std::vector<std::string> arrays;
    for (const auto* list : {&plan.parameters, &plan.start})
        for (const std::string& field : *list) arrays.push_back(names.unique(field));
    return arrays;
}

std::string cpp_call(const std::string& head, const std::string& type, const std::string& function,
                     const std::vector<CppResult>& list) {
    const std::vector<std::string> none(list.size(), "none");
    return filled(frames::call, {{"call", head},
                                 {"Values", type},
                                 {"compute", function},
                                 {"none", fmt::format("{}", fmt::join(none, ", "))}});
}

std::string cpp_fields(const CppPlan& plan) {
    const std::vector<std::string> arrays = cpp_argument_arrays(plan);
    std::size_t next = 0;
    std::string text;
    for (const auto& [kind, type, list] : {std::tuple("parameter", "Parameters", &plan.parameters),
                                           std::tuple("start", "Start", &plan.start)}) {
        std::vector<std::string> own, given;
        for (const std::string& field : *list) {
            own.push_back(fmt::format("&{}::{}", type, field));
            given.push_back(fmt::format("&Members::{}", arrays[next++]));
        }
        text += filled(frames::fields, {{"kind", kind},
                                        {"Struct", type},
                                        {"count", std::to_string(list->size())},
                                        {"fields", fmt::format("{}", fmt::join(own, ", "))},
                                        {"arrays", fmt::format("{}", fmt::join(given, ", "))}});
    }
    return text + "\n";
}

std::string cpp_interface(CppPlan& plan, const std::vector<PlannedFurther>& further) {
    return CppInterface(plan, further).print();
}

} // namespace resonform
