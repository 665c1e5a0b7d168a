// SPDX-License-Identifier: GPL-3.0-or-later
// The exact solution behind a stability sweep: parameters are inputs, those of [fix] included where the
// program takes them.
#pragma once

#include "verify/stability/points.hpp"
#include "verify/symbolic/evaluator.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

// The condition number of each output: its change, over its scale, per relative change of an input other than
// t, added up over the inputs. In ulp, that is what a last bit of the inputs does: no code with inputs in
// double could be required to do better.
struct Conditioning {
    std::vector<double> sum;
    std::vector<std::string> input; // that does most, as [start] and [fix] name it; "": none does anything
    // The same of the slow time eps t alone. It is a product of two inputs, and rounded: e^(-eps t) at
    // eps t = 600 is off by up to 300 ulp of itself.
    std::vector<double> slow_time;

    Conditioning() = default;
    Conditioning(std::size_t outputs, double of_each)
        : sum(outputs, of_each), input(outputs), slow_time(outputs, 0.0) {}
};

class StabilityReference {
public:
    // Of the inputs that the program does not take, the values are those of the scene. All three must outlive
    // it.
    StabilityReference(const Program& program, const Solution& solution, const Scene& scene);

    // Where the declared domain is not left at once.
    [[nodiscard]] bool inside(const SweepPoint& at) const;

    // The exact solution from one start. A slow flow is followed as far as a few tables lead:
    // outside_interval beyond.
    class From {
    public:
        From(const StabilityReference& reference, const SweepPoint& at, double end);

        // Times are asked in ascending order: the scales of outputs are kept along the way.
        [[nodiscard]] const SymbolicPoint& at(double t);
        // Of each value that the evaluator has at t, in units of the last place of the output's scale there;
        // of a slow flow, of the largest scale so far, for its tables are accurate relative to that. Infinite
        // where the exact solution has no number.
        [[nodiscard]] std::vector<double> ulp(double t, const std::vector<double>& values);
        // One ulp of each output's scale at the last time asked for.
        [[nodiscard]] std::vector<double> units() const;
        // Evaluators answer for a phase to 10^-9 radians, and up to 10^14; here 16 ulp of it are more, or it
        // is within a factor of 10 of that: at t, or in the eighth of the interval that follows, for a table
        // may answer for so much of it at once.
        [[nodiscard]] bool has_large_phase(double t) const;
        // Emitted code in double has no phase at t, or ends within this eighth of the interval.
        [[nodiscard]] bool loses_phase(double t) const;
        // At t, with the phases unchanged. Infinite, and no input named, where the status is another one for
        // a start that close, or within 4 ulp of t.
        [[nodiscard]] Conditioning conditioning(double t);

    private:
        struct Beside { // with one input changed by its last bit
            std::string input;
            SymbolicEvaluator exact;
        };
        // Made when they are asked for, once for all times: the k-th, nullptr beyond the last.
        const Beside* beside(std::size_t k);
        [[nodiscard]] Wide known_end() const;

        const StabilityReference& reference_;
        SymbolicInputs inputs_;
        SymbolicEvaluator exact_;
        std::vector<Beside> beside_;
        std::map<double, SymbolicPoint> known_;
        std::vector<Wide> scales_; // of each output
    };

private:
    [[nodiscard]] SymbolicInputs inputs_at(const SweepPoint& at, double end) const;

    const Program& program_;
    const Scene& scene_;
    bool is_flow_;
    Tape start_; // of the scene
    std::shared_ptr<const SymbolicSolution> solution_;
    std::vector<Float128> parameters_; // of the scene
};

} // namespace resonform
