// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/c_interface.hpp"

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

std::string stores(const std::vector<CppResult>& results, const std::string& target,
                   const std::string& suffix) {
    std::string text;
    for (std::size_t k = 0; k < results.size(); ++k)
        text += fmt::format("    {}[{}]{} = values.{};\n", target, k, suffix, results[k].name);
    return text;
}

// The functions of one real type behind a template, and their C names.
const char* const interface_text = R"(
template <class Real> void* library_new(const Real* eps, [[maybe_unused]] const Real* parameters,
                                        [[maybe_unused]] const Real* start, const Real* slow_time_end) {{
    using Scene = {0}<Real>;
    return new Scene(*eps, typename Scene::Parameters{1}, typename Scene::Start{2}, *slow_time_end);
}}

template <class Real> int library_call(const void* scene, const Real* t, Real* outputs) {{
    typename {0}<Real>::Values values;
    const resonform::Status status = (*static_cast<const {0}<Real>*>(scene))(*t, values);
{3}    return static_cast<int>(status);
}}

template <class Real>
void library_batch(const void* scene, const Real* t, long n, Real* const* outputs, unsigned char* status) {{
    for (long i = 0; i < n; ++i) {{
        typename {0}<Real>::Values values;
        status[i] = static_cast<unsigned char>((*static_cast<const {0}<Real>*>(scene))(t[i], values));
    {4}    }}
}}
)";

const char* const state_text = R"(
template <class Real> int library_state(const void* scene, const Real* t, Real* state) {{
    typename {0}<Real>::State values;
    const resonform::Status status = static_cast<const {0}<Real>*>(scene)->state(*t, values);
{1}    return static_cast<int>(status);
}}
)";

const char* const names_text = R"(
void* rf_new_{0}(const {1}* eps, const {1}* parameters, const {1}* start, const {1}* slow_time_end) {{
    return library_new<{1}>(eps, parameters, start, slow_time_end);
}}
const char* rf_why_{0}(const void* scene, int status) {{
    return static_cast<const {2}<{1}>*>(scene)->why(static_cast<resonform::Status>(status));
}}
void rf_delete_{0}(void* scene) {{ delete static_cast<{2}<{1}>*>(scene); }}
int rf_call_{0}(const void* scene, const {1}* t, {1}* outputs) {{ return library_call(scene, t, outputs); }}
void rf_batch_{0}(const void* scene, const {1}* t, long n, {1}* const* outputs, unsigned char* status) {{
    library_batch(scene, t, n, outputs, status);
}}
)";

} // namespace

std::string cpp_c_interface(const Program& program, const std::string& evaluator) {
    const CppPlan plan(program);
    std::string batch_stores = stores(plan.outputs, "outputs", "[i]");
    std::string text = fmt::format(
        fmt::runtime(interface_text), evaluator, elements("parameters", program.parameters.size()),
        elements("start", program.start.size()), stores(plan.outputs, "outputs", ""), batch_stores);
    if (!plan.state.empty())
        text += fmt::format(fmt::runtime(state_text), evaluator, stores(plan.state, "state", ""));
    text += "\nextern \"C\" {\n";
    for (const auto& [letter, real] :
         {std::pair("d", "double"), std::pair("l", "long double"), std::pair("q", "resonform::Float128")}) {
        text += fmt::format(fmt::runtime(names_text), letter, real, evaluator);
        if (!plan.state.empty())
            text += fmt::format("int rf_state_{0}(const void* scene, const {1}* t, {1}* state) {{ return "
                                "library_state(scene, t, state); }}\n",
                                letter, real);
    }
    return text + "}\n";
}

} // namespace resonform
