// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of a solution (amplitude, phase, constants of the drifts): arguments of the evaluator
// where the scene gives them, computed from physical start values through the inverse map elsewhere.
#pragma once

#include "emit/program/flow_moment.hpp"
#include "solve/initial_values.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace resonform {

class StartConstants {
public:
    // slow_starts: the slow variables at t = 0; names: symbols that start values may contain.
    StartConstants(Program& program, const Solution& solution, const Scene& scene,
                   std::map<GeneratorId, Graph::Node> slow_starts, std::map<std::string, Graph::Node> names)
        : program_(program), solution_(solution), scene_(scene), slow_starts_(std::move(slow_starts)),
          names_(std::move(names)) {}

    // Adds a node for every constant to the surroundings; returns theta_0, -1 without an oscillator.
    // Where the equation for the amplitude is implicit, C = R/(eps E F(C)), it is solved by M + 1
    // substitutions, each of which gains a power of eps: as accurate as the map through weight M.
    Graph::Node define(Surroundings& surroundings);
    // After define(): that the solution starts where its map is close to the identity.
    void require_map(const Surroundings& surroundings);

private:
    Graph::Node input(const std::string& name, const std::string& meaning, const std::string& canonical);
    [[nodiscard]] bool is_physical(std::size_t variable) const;
    void define_given(Surroundings& surroundings);
    void define_derived(const InitialValues& values, Surroundings& surroundings);
    void define_physical_values(const InitialValues& values, Moment& start);
    void derive_oscillator(const InitialValues& values, Moment& start, Surroundings& surroundings);
    [[nodiscard]] MomentPlan plan() const;
    FlowUnit old_mode(const RealForm& real, FlowMoment& at);

    Program& program_;
    const Solution& solution_;
    const Scene& scene_;
    std::map<GeneratorId, Graph::Node> slow_starts_;
    std::map<std::string, Graph::Node> names_;
    std::map<std::string, Graph::Node> physical_; // states
    Graph::Node phase_start_ = -1;
};

} // namespace resonform
