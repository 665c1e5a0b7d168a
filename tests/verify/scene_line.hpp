// SPDX-License-Identifier: GPL-3.0-or-later
// A scene of systems/ taken through the line, for tests that verify it.
#pragma once

#include "solve/solve.hpp"
#include "support/program.hpp"
#include "verify/judging/ladder.hpp"

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
    line.system = std::make_shared<const FirstOrderSystem>(solve_for_highest(line.scene.system));
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

inline Solution derive(std::shared_ptr<const System> system, int order, int truncation) {
    const auto first_order = std::make_shared<const FirstOrderSystem>(solve_for_highest(std::move(system)));
    const auto field = std::make_shared<const GradedField>(expand(first_order));
    return solve(std::make_shared<const Normalization>(normalize(field, truncation)), {order, truncation});
}

inline VerifyOptions options() {
    VerifyOptions o;
    o.guarantee = [](const Scene& scene, const Solution& solution, const Claims& claims) {
        return guarantees(scene, solution, claims, derive);
    };
    o.cache = std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache";
    o.emitted_starts = 5;
    return o;
}

// Interpreted: most of the time of a ladder is the compiler's, twice a scene. That its code gives what the
// interpreter gives is a test of its own (check_emitted.cpp), and every scene of systems/ is verified
// compiled.
inline Verification verified(const SceneLine& line) {
    VerifyOptions o = options();
    o.compiled = false;
    return verify(line.system, line.scene, line.solution, o);
}
inline Verification verified_compiled(const SceneLine& line) {
    return verify(line.system, line.scene, line.solution, options());
}

} // namespace resonform::test
