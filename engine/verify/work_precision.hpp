// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time: the emitted evaluator beside direct integrators, at one eps.
#pragma once

#include "verify/ladder.hpp"

#include <optional>
#include <string>
#include <vector>

namespace resonform {

enum class Task { final, dense }; // one point at the end; many points over the interval
const char* to_string(Task task);

struct ComparisonRow {
    std::string method;  // "emitted", "CVODE Adams", "odeint dopri5", "Taylor"
    std::string setting; // "order 3", "tolerance 1e-8"
    Task task = Task::final;
    std::size_t points = 0;
    std::vector<double> max_error; // of each output
    double seconds = 0;            // the task, construction not included
    double construction_seconds = 0;
    std::string failure; // empty if the method reached the end
};

// One rival at the accuracy of the emitted evaluator: the fastest of its rows that is no worse in any
// output. Empty seconds: no tolerance tried reached it.
struct RivalAtEqualAccuracy {
    std::string method;
    std::optional<double> seconds;
    std::optional<double> ratio; // rival / emitted; below 1 the rival wins
};

struct BreakEven {
    Task task = Task::final;
    double emitted_seconds = 0; // construction included
    std::vector<RivalAtEqualAccuracy> rivals;
    std::string winner; // the fastest of all at equal accuracy
};

struct Comparison {
    std::string system, scene;
    Rational eps;
    std::vector<std::string> outputs;
    std::vector<ComparisonRow> rows;
    std::vector<BreakEven> break_even;
};

struct CompareOptions : VerifyOptions {
    Rational eps = Rational(1) / 1000;
    std::size_t dense_points = 1000000;
};

Comparison compare(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                   const Solution& solution, const CompareOptions& options);

std::string to_text(const Comparison& comparison);

} // namespace resonform
