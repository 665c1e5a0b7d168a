// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time: the emitted evaluator beside direct integrators. All are code of one compiler, with
// the values of [fix] put in; all buffers are made before the clock runs; all give the wanted outputs only.
#pragma once

#include "verify/judging/ladder.hpp"
#include "verify/judging/timing.hpp"

#include <optional>
#include <string>
#include <vector>

namespace resonform {

enum class Task { final, dense }; // one point at the end; many points over the interval
const char* to_string(Task task);

struct ComparisonRow {
    Rational eps;
    std::string method;  // "emitted", "CVODE Adams", "odeint dopri5", "Taylor"
    std::string setting; // "order 3", "tolerance 1e-8"
    Task task = Task::final;
    std::size_t points = 0;
    std::vector<double> max_error; // of each output
    Timing seconds;                // the task, with everything made before
    double construction_seconds = 0;
    std::string failure; // empty if the method reached the end

    [[nodiscard]] double total_seconds() const { return seconds.median + construction_seconds; }
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
    double emitted_seconds = 0; // construction included, as in those of the rivals
    std::vector<RivalAtEqualAccuracy> rivals;
    std::string winner;       // the fastest of all at equal accuracy
    std::string failure = {}; // why the emitted evaluator has no numbers: then nobody wins
};

// The accuracy asked of everyone is the emitted code's along the whole run: at a single time an error
// may vanish by accident.
BreakEven break_even(const std::vector<ComparisonRow>& rows, const ComparisonRow& emitted,
                     const ComparisonRow& along);

struct BreakEvenAtEps {
    Rational eps;
    std::vector<BreakEven> tasks;
};

struct Comparison {
    std::string system, scene;
    std::vector<std::string> outputs;
    std::vector<ComparisonRow> rows;
    std::vector<BreakEvenAtEps> by_eps; // in the order asked for
};

struct CompareOptions : VerifyOptions {
    std::vector<Rational> eps = {Rational(1) / 1000};
    std::size_t dense_points = 1000000;
    double silence = 5; // seconds: progress names a method that takes longer
};

Comparison compare(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                   const Solution& solution, const CompareOptions& options);

std::string to_text(const Comparison& comparison);

} // namespace resonform
