// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/c_interface.hpp"

#include "emit/cpp/embedded_text.hpp"
#include "emit/cpp/interface.hpp"
#include "emit/cpp/plan.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

// "{first[0], first[1]}"
std::string elements(const std::string& array, std::size_t count) {
    std::string text;
    for (std::size_t k = 0; k < count; ++k) text += fmt::format("{}{}[{}]", k == 0 ? "" : ", ", array, k);
    return "{" + text + "}";
}

std::string stores(const std::vector<CppResult>& results, const std::string& target) {
    std::string text;
    for (std::size_t k = 0; k < results.size(); ++k)
        text += fmt::format("    {}[{}] = values.{};\n", target, k, results[k].name);
    return text;
}

} // namespace

std::string cpp_c_interface(const Program& program, const std::string& evaluator, std::string_view types) {
    const CppPlan plan(program);
    std::string arrays;
    for (std::size_t k = 0; k < plan.outputs.size(); ++k) arrays += fmt::format("outputs[{}], ", k);
    const std::vector<std::pair<std::string_view, std::string>> holes{
        {"Evaluator", evaluator},
        {"parameters", elements("parameters", program.parameters.size())},
        {"start", elements("start", program.start.size())},
        {"outputs", stores(plan.outputs, "outputs")}};
    std::string text = "\n" + filled(frames::library, holes);
    if (!plan.state.empty())
        text += "\n" + filled(frames::library_state,
                              {{"Evaluator", evaluator}, {"state", stores(plan.state, "state")}});
    text += "\nextern \"C\" {\n";
    for (const auto& [letter, real] :
         {std::pair('d', "double"), std::pair('l', "long double"), std::pair('q', "resonform::Float128")}) {
        if (types.find(letter) == std::string_view::npos) continue;
        text += "\n" + filled(frames::library_names,
                              {{"letter", std::string(1, letter)}, {"Real", real}, {"Evaluator", evaluator}});
        if (letter == 'd')
            text += filled(frames::library_many, {{"Evaluator", evaluator}, {"arrays", arrays}});
        if (!plan.state.empty())
            text += fmt::format("int rf_state_{0}(const void* scene, const {1}* t, {1}* state) {{ return "
                                "library_state(scene, t, state); }}\n",
                                letter, real);
    }
    if (types.find('f') != std::string_view::npos) text += filled(frames::library_end, holes);
    if (types.find('e') != std::string_view::npos) {
        std::string members = "    members.eps = arguments[0];\n";
        std::size_t next = 1;
        for (const std::string& array : cpp_argument_arrays(plan))
            members += fmt::format("    members.{} = arguments[{}];\n", array, next++);
        if (plan.has_full_phase()) members += "    members.full_phase = full_phase != 0;\n";
        std::string parameters;
        for (std::size_t k = 0; k < plan.parameters.size(); ++k)
            parameters +=
                fmt::format("        if (arguments[{0}] != nullptr) parameters.{1} = arguments[{0}][i];\n",
                            k + 1, plan.parameters[k]);
        text += filled(
            frames::library_ensemble,
            {{"Evaluator", evaluator}, {"members", members}, {"arrays", arrays}, {"parameters", parameters}});
    }
    return text + "}\n";
}

} // namespace resonform
