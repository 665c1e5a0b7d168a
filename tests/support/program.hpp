// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as a program, for the tests of emitted and interpreted code.
#pragma once

#include "emit/program/build_program.hpp"
#include "emit/program/program.hpp"
#include "model/files/read_scene.hpp"
#include "normalize/styles/normalize.hpp"
#include "solve/flow/solve_options.hpp"
#include "solve/solve.hpp"
#include "solve/truncation.hpp"
#include "support/exact.hpp"

#include <memory>
#include <string>
#include <utility>

namespace resonform::test {

inline Solution solution_of(const Scene& scene) {
    const auto first_order = std::make_shared<const FirstOrderSystem>(solve_for_highest(scene.system));
    const auto field = std::make_shared<const GradedField>(expand(first_order));
    const int truncation = count_truncation(*field, scene).truncation;
    auto normalization = std::make_shared<const Normalization>(normalize(field, truncation));
    return solve(std::move(normalization), options_of(scene, scene.order, truncation));
}

// systems/<system>/scenes/<name>.toml
inline Scene scene_of(const std::string& system, const std::string& name) {
    const std::filesystem::path systems = source_dir() / "systems";
    return read_scene(systems / system / "scenes" / (name + ".toml"), systems);
}

inline Scene pendulum_scene(const std::string& name) { return scene_of("almost_holonomic_pendulum", name); }

inline std::shared_ptr<const Program> program_of(const Scene& scene, const ProgramOptions& options = {}) {
    return std::make_shared<const Program>(build_program(solution_of(scene), scene, options));
}

} // namespace resonform::test
