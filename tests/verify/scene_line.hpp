// SPDX-License-Identifier: GPL-3.0-or-later
// A scene of systems/ taken through the line, for tests that verify it.
#pragma once

#include "support/program.hpp"
#include "verify/ladder.hpp"

#include <memory>
#include <string>
#include <utility>

namespace resonform::test {

struct SceneLine {
    Scene scene;
    Solution solution;
    std::shared_ptr<const FirstOrderSystem> system;
};

inline SceneLine line_of(Scene scene) {
    SceneLine line{std::move(scene), {}, nullptr};
    line.solution = solution_of(line.scene);
    line.system = line.solution.normalization->normal_form.field->first_order;
    return line;
}

inline SceneLine pendulum(const std::string& name) { return line_of(pendulum_scene(name)); }

// eps = 0.02, 0.01, 0.005, 0.002, 0.001: the slopes of the pendulum are straight there, and it is quick.
inline void shorten_ladder(Scene& scene) {
    scene.verify.eps.clear();
    for (const int inverse : {50, 100, 200, 500, 1000})
        scene.verify.eps.push_back(Rational(1) / Rational(inverse));
    scene.verify.eps_given = true;
}

inline VerifyOptions options() {
    VerifyOptions o;
    o.cache = std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache";
    return o;
}

inline Verification verified(const SceneLine& line) {
    return verify(line.system, line.scene, line.solution, options());
}

} // namespace resonform::test
