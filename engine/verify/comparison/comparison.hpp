// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time: the emitted evaluator beside direct integrators. All are code of one compiler, with
// the values of [fix] put in; all buffers are made before the clock runs; all give the wanted outputs only.
#pragma once

#include "verify/comparison/timing.hpp"
#include "verify/judging/ladder.hpp"
#include "verify/run/machine.hpp"

#include <optional>
#include <string>
#include <vector>

namespace resonform {

// What is asked of everyone, of T the end of the interval.
enum class Task {
    final,    // the outputs at T
    dense,    // at many times 0 ... T, given as an array
    grid,     // at the same times, given as t0 + i dt
    ensemble, // at T, of many members that start elsewhere
};
const char* to_string(Task task);
std::vector<std::string> task_names(); // in the order of the enumeration
Task task_of(const std::string& name); // precondition: it is one of these

// How emitted code is called.
enum class Form {
    scalar,   // operator(), one time after the other
    batch,    // an array of times
    grid,     // t0 + i dt
    at_end,   // one time, nothing constructed before
    ensemble, // many members, nothing constructed before
};
const char* to_string(Form form); // "final" of at_end

struct ComparisonRow {
    Rational eps;
    std::string method;  // "emitted", "CVODE Adams", "odeint dopri5", "Taylor"
    std::string setting; // "order 3", "tolerance 1e-8"
    Task task = Task::final;
    std::optional<Form> form; // of emitted code
    Rational order = 0;       // of emitted code
    std::size_t points = 0;   // of each member
    std::size_t members = 1;
    std::size_t run_members = 1;   // that ran in fact: of rivals fewer, and `seconds` are scaled to all
    std::vector<double> max_error; // of each output
    Timing seconds;                // the task, with everything made before
    double construction_seconds = 0;
    std::string failure; // empty if the method reached the end

    [[nodiscard]] bool is_emitted() const { return form.has_value(); }
    [[nodiscard]] double total_seconds() const { return seconds.median + construction_seconds; }
};

// One rival at the accuracy of the emitted evaluator: at the loosest tolerance at which no output is worse
// (verify/comparison/equal_accuracy.hpp). No seconds: no tolerance reached it.
struct RivalAtEqualAccuracy {
    std::string method;
    std::optional<double> seconds = {}; // construction included
    std::optional<double> ratio = {};   // rival / emitted; below 1 the rival wins
    double tolerance = 0;
    double error_ratio = 0; // largest error along the run over that of the emitted code, worst output
    Timing spread = {};     // without construction
    std::optional<double> to_end = {}; // seconds to the end of the run with no point but that
};

// One task at one eps, of the emitted code of one order.
struct BreakEven {
    Task task = Task::final;
    double emitted_seconds = 0; // construction included, as in those of the rivals
    std::vector<RivalAtEqualAccuracy> rivals;
    std::string winner;       // the fastest of all at equal accuracy
    std::string failure = {}; // why the emitted evaluator has no numbers: then nobody wins
    Rational order = 0;
    std::size_t measured_points = 1, members = 1;
    std::optional<Form> form = {}; // the fastest
    double construction_seconds = 0;
    // Where it pays; nullopt: nowhere. From so many points on (both costs grow evenly with the points) no
    // rival is faster; at this and all smaller eps that were asked for; after so many runs the time that
    // derivation and compilation took is won back from the fastest rival.
    std::optional<double> points = {};
    std::optional<Rational> eps = {};
    std::optional<double> runs = {};
};

struct BreakEvenAtEps {
    Rational eps;
    std::vector<BreakEven> tasks; // order by order, the highest last
};

// What emitted code costs before its first number.
struct Preparation {
    Rational order = 0;
    double derivation_seconds = 0; // of the highest order, for all
    double compilation_seconds = 0;
};

struct Comparison {
    std::string system, scene;
    std::vector<std::string> outputs;
    std::vector<Preparation> prepared; // ascending orders
    std::vector<ComparisonRow> rows;
    std::vector<BreakEvenAtEps> by_eps; // in the order asked for
    Machine machine = {};
    bool pinned = false; // the threads that were timed kept their processor
};

struct CompareOptions : VerifyOptions {
    std::vector<Rational> eps = {Rational(1) / 1000};
    std::vector<int> orders = {}; // ascending; empty: that of the scene alone
    std::vector<Task> tasks = {Task::final, Task::dense};
    std::vector<std::size_t> points = {1000000}; // of dense and grid; ascending, each >= 2
    std::size_t members = 10000;                 // of ensemble
    int repetitions = 0;           // of each timing; 0: 3 ... 15, until a fifth of a second is spent
    double derivation_seconds = 0; // what the solution took
    double silence = 5;            // seconds: progress names a method that takes longer
};

// Precondition: the normal form of the solution goes as far as the highest order asks. Errors: those of
// Trial; refused, the interval lies within the layer that a scene without transients leaves out.
Comparison compare(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                   const Solution& solution, const CompareOptions& options);

std::string setting_of(double tolerance); // "tolerance 1e-08", "tolerance 2.35e-12"

std::string to_text(const Comparison& comparison);
std::string to_csv(const Comparison& comparison); // its rows

} // namespace resonform
