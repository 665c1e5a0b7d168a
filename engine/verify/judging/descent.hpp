// SPDX-License-Identifier: GPL-3.0-or-later
// Down a ladder of eps: which rungs can be integrated, the errors on each, and what the judge says of them.
#pragma once

#include "verify/estimate/times.hpp"
#include "verify/judging/trial.hpp"
#include "verify/judging/verification.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

// One eps with everything that is read off the scene for it.
struct PlannedRung {
    TrialPoint at;
    std::optional<std::size_t> steps; // of a run in double; nullopt: too many
    double rate = 0;                  // largest_rate()
    double from = 0;                  // layer_end(): where the times begin
    double layer = 0;                 // layer_length()
    std::optional<TrialPoint> defect; // beside modes that grow: where the defect is computed, if it is
};

class Descent {
public:
    // Fills `result` with names, conditions and the outputs with their claims; all must outlive it.
    Descent(const Trial& trial, const Scene& scene, const Solution& solution, Verification& result);

    // Plans all rungs before any is integrated; the first that takes too many steps ends the ladder, and
    // result.conditions.ladder_end says why. Errors: those of Trial::point and Trial::steps.
    [[nodiscard]] std::vector<PlannedRung> planned(const std::vector<Rational>& ladder);
    // Integrates them, side by side, and judges what there is by now. Numbers alone: neither GiNaC nor
    // anything that other threads may share. Errors: those of Trial::reference.
    void measure(const std::vector<PlannedRung>& rungs);

    // Both.
    void along(const std::vector<Rational>& ladder) { measure(planned(ladder)); }
    // The rounding of long double on each rung, as found. That of a formula in which a coefficient is another
    // one is the same: told before its rungs are measured, it is not sought again.
    using Roundings = std::map<Rational, std::vector<double>>; // by eps: of each output
    [[nodiscard]] const Roundings& roundings() const { return roundings_; }
    void know(Roundings roundings) { roundings_ = std::move(roundings); }
    // A default ladder that has not settled goes on.
    void further();

private:
    [[nodiscard]] std::optional<LadderEnd> end_at(const Rational& eps) const;
    [[nodiscard]] PlannedRung rung(const Rational& eps);
    struct Measured;
    [[nodiscard]] Measured measured(const PlannedRung& plan) const;
    void add(const PlannedRung& plan, const Measured& found);
    void add_defect(const PlannedRung& plan, const Measured& found);
    void note(const SampleTimes& times, double length, double rate);

    const Trial& trial_;
    const Scene& scene_;
    const GradedField& field_;
    Verification& result_;
    Roundings roundings_;
    bool growing_ = false, follows_growth_ = false;
    std::size_t steps_of_last_ = 0;
};

// A formula that leaves too large a defect is wrong, whatever a short ladder says of it.
void weigh_defects(Verification& result);

} // namespace resonform
