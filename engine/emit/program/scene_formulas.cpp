// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/scene_formulas.hpp"

#include "emit/derive/derive.hpp"
#include "emit/derive/flow.hpp"
#include "emit/display/page.hpp"
#include "emit/program/harmonics.hpp"
#include "solve/flow/slow_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace resonform {

namespace {

// The solution with the outputs of the scene alone, without e^{i theta} if the scene does not oscillate.
Solution narrowed(Solution solution, const Scene& scene) {
    std::vector<SolutionOutput> outputs;
    for (SolutionOutput& output : solution.outputs)
        if (std::count(scene.outputs.begin(), scene.outputs.end(), output.name) > 0)
            outputs.push_back(std::move(output));
    for (SolutionOutput& output : outputs)
        for (int n = 0; !scene.oscillating && !solution.modes.empty() && n <= output.value.through(); ++n)
            output.value.set(n,
                             harmonic(*solution.ring, solution.modes.front().phase, output.value.part(n), 0));
    solution.outputs = std::move(outputs);
    return solution;
}

// Of a long formula the first lines.
std::vector<std::string> lines_of(const Page& page) {
    constexpr int longest = 60;
    std::istringstream text(page_text(page));
    std::vector<std::string> lines;
    int long_by = 0; // lines of this formula
    const auto end_formula = [&] {
        if (long_by > longest)
            lines.push_back(
                fmt::format("          + ... ({} lines more, of `resonform derive --stage solution`)",
                            long_by - longest));
        long_by = 0;
    };
    for (std::string line; std::getline(text, line);) {
        if (line.empty()) continue;
        if (line.front() != ' ') end_formula();
        if (++long_by <= longest) lines.push_back(line);
    }
    end_formula();
    return lines;
}

// The outputs of the scene, only their mean parts if the scene does not oscillate.
std::vector<FlowOutput> narrowed_outputs(const Solution& solution, const Scene& scene) {
    const GradedField& field = *solution.normalization->normal_form.field;
    std::vector<FlowOutput> outputs;
    for (FlowOutput output : solution.flow->outputs) {
        if (std::count(scene.outputs.begin(), scene.outputs.end(), output.name) == 0) continue;
        for (int n = 0; !scene.oscillating && n <= output.value.through(); ++n)
            output.value.set(n, mean_part(field, *solution.flow, output.value.part(n)));
        outputs.push_back(std::move(output));
    }
    return outputs;
}

} // namespace

std::vector<std::string> scene_formulas(const Solution& solution, const Scene& scene, bool with_phase) {
    if (solution.flow) {
        Page page;
        const std::vector<FlowOutput> outputs = narrowed_outputs(solution, scene);
        page.sections = flow_sections(solution, outputs);
        for (Section& section : page.sections) section.heading.clear();
        return lines_of(page);
    }
    Page all = solution_page(narrowed(solution, scene)), page;
    for (Section& section : all.sections) {
        const bool amplitude_and_phase = section.heading == "amplitude and phase";
        if (section.heading == "drift" || (amplitude_and_phase && !with_phase)) continue;
        if (amplitude_and_phase) section.formulas = {section.formulas.back()}; // theta = theta_0 + ...
        section.heading.clear();
        page.sections.push_back(std::move(section));
    }
    define_slow_time(page, solution);
    return lines_of(page);
}

} // namespace resonform
