// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/scene_formulas.hpp"

#include "emit/derive.hpp"
#include "emit/harmonics.hpp"

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

} // namespace

std::vector<std::string> scene_formulas(const Solution& solution, const Scene& scene, bool with_phase) {
    Page all = solution_page(narrowed(solution, scene)), page;
    for (Section& section : all.sections) {
        const bool amplitude_and_phase = section.heading == "amplitude and phase";
        if (section.heading == "drift" || (amplitude_and_phase && !with_phase)) continue;
        if (amplitude_and_phase) section.formulas = {section.formulas.back()}; // theta = theta_0 + ...
        section.heading.clear();
        page.sections.push_back(std::move(section));
    }
    define_slow_time(page, solution);
    std::istringstream text(page_text(page));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

} // namespace resonform
