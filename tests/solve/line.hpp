// SPDX-License-Identifier: GPL-3.0-or-later
// The line from a system's text or file to its solution, for the tests of this room.
#pragma once

#include "expand/expansion/graded_field.hpp"
#include "model/files/read_system.hpp"
#include "normalize/recursion/poincare.hpp"
#include "solve/solution.hpp"
#include "solve/solve.hpp"

#include <memory>
#include <string>
#include <utility>

namespace resonform::testing {

inline std::shared_ptr<const GradedField> field_of(System system) {
    auto first_order = std::make_shared<const FirstOrderSystem>(
        solve_for_highest(std::make_shared<const System>(std::move(system))));
    return std::make_shared<const GradedField>(expand(std::move(first_order)));
}

inline Solution solution_of(System system, const SolveOptions& options) {
    auto normalization = std::make_shared<const Normalization>(
        normalize_poincare(field_of(std::move(system)), options.truncation));
    return solve(std::move(normalization), options);
}

inline Solution solution_of(System system, int order, int truncation, int time_scale = 1) {
    return solution_of(std::move(system), {order, truncation, time_scale});
}

inline Solution solution_of_text(const std::string& toml, int order, int truncation, int time_scale = 1) {
    return solution_of(read_system_text(toml, "test.toml"), order, truncation, time_scale);
}

inline System pendulum() {
    return read_system(std::string(RESONFORM_SOURCE_DIR) + "/systems/almost_holonomic_pendulum/system.toml");
}

inline const GradedField& field(const Solution& solution) {
    return *solution.normalization->normal_form.field;
}

inline Polynomial rate_of_mode(const Solution& solution, std::size_t k) {
    const Series& rate = solution.flow->modes[k].rate;
    return rate.total(rate.through());
}

} // namespace resonform::testing
