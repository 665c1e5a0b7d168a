// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/estimate/next_weight.hpp"

#include "model/files/interval_length.hpp"
#include "model/system/start_names.hpp"
#include "solve/truncation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

bool starts_from_constants(const Scene& scene) {
    return std::any_of(scene.start.begin(), scene.start.end(), [&](const StartValue& start) {
        return canonical_start(start.name, *scene.system).find('.') != std::string::npos;
    });
}

} // namespace

std::optional<int> time_power(const Scene& scene) {
    const std::optional<int> power = growth_power(scene, scene.verify.interval);
    if (!power) return {};
    return std::max(scene.slow_power(), *power);
}

TruncatedFormula formula_of(const Scene& scene, const Solution& solution, int time_power) {
    return {solution.order, solution.truncation, time_power, scene.oscillating, starts_from_constants(scene)};
}

int counted_truncation(const Scene& scene, const Solution& solution, int order) {
    Scene other = scene;
    other.order = order;
    other.truncation.reset();
    return count_truncation(*solution.normalization->normal_form.field, other).truncation;
}

std::string told(const Error& error) {
    const Diagnostic& d = error.diagnostic();
    return d.value.empty() ? d.rule : fmt::format("{} ({})", d.rule, d.value);
}

} // namespace resonform
