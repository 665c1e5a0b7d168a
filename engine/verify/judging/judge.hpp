// SPDX-License-Identifier: GPL-3.0-or-later
// From the errors of an eps-ladder to a verdict: error = O(eps^q), which q?
#pragma once

#include "model/system/scene_file.hpp"
#include "runtime/status.hpp"
#include "verify/estimate/error_estimate.hpp"
#include "verify/judging/guarantee.hpp"

#include <optional>
#include <string>
#include <vector>

namespace resonform {

// One eps: max and RMS of |emitted - direct| over the interval.
struct LadderRung {
    Rational eps;
    double max_error = 0, rms_error = 0;
    int digits = 0;              // decimal digits of the arithmetic used
    double reference_error = 0;  // estimated error of the direct integration
    double floor = 0;            // rounding of the evaluator at this rung: smaller errors are invisible
    double scale = 1;            // max |output| over the interval
    std::string refusal;         // where the evaluator has no numbers: "outside_domain: 1 - tau at t = 3"
    Status refused = Status::ok; // the same as a status
};

struct DataError { // (verify/judging/data_error.hpp)
    double eps = 0;
    double error = 0; // NaN: the motion with fewer samples does not reach the end
};

struct OutputVerdict {
    std::string name;
    int eps_root = 1; // orders are held in units of 1/eps_root, as weights are
    int claimed_order = 0;
    std::optional<int> guaranteed_order; // by the count of weights; none: it does not hold here
    std::optional<int> found_order;      // none while undecided
    Verdict verdict = Verdict::undecided, expected = Verdict::pass;
    double slope = 0, slope_low_eps = 0, slope_high_eps = 0; // asymptotic slope and its window
    double constant = 0;                                     // lim max|error| / eps^found_order
    // An order as the user counts it.
    [[nodiscard]] Rational order(int held) const { return Rational(held) / eps_root; }
    // The ladder shows a lower order than is claimed: `reason` says no more than the orders do.
    [[nodiscard]] bool fails_by_order() const {
        return verdict == Verdict::fail && found_order && *found_order < claimed_order;
    }
    std::string reason;                    // when undecided or failed
    std::vector<LadderRung> ladder;        // eps descending
    std::vector<LadderRung> layer;         // the same within t <= 20/|Re lambda|, where modes decay
    double layer_slope = 0;                // as slope, of the layer
    std::vector<double> local_slopes;      // between rungs; one fewer
    std::optional<ErrorEstimate> estimate; // none: it was not asked for
    std::optional<double> estimate_ratio;  // estimated/true; none: nothing to compare
    std::optional<DataError> data_error;   // none: no data, or too few
};

// The error is clear of the reference's and the arithmetic's own.
bool usable(const LadderRung& rung);

// Pure. Reads name, eps_root, claimed_order, expected, ladder and layer; fills the rest. Errors are series in
// e = eps^(1/eps_root): slopes are judged, and extrapolated, over e, where orders are integers, and told over
// eps. For eps_root = 1:
//   usable rungs     max_error >= 100 max(reference_error, floor)
//   local slopes     s_k = ln(e_k/e_{k+1}) / ln(eps_k/eps_{k+1})
//   slope            its limit as eps -> 0, extrapolated from the smallest usable eps
//   constant         the limit of max_error/eps^found_order, extrapolated likewise
// undecided: fewer than 3 usable rungs, an evaluator that refuses points at a smaller eps than it answers,
// slope not within 0.3 of an integer (a straight one: more than 0.05 below it), still bending or leaving
// the integer; the reason says which. An output without a usable rung passes if 100 max(reference_error,
// floor) <= 1e-3 min(1, scale) eps^claimed_order on half of the rungs and on 3: else it is undecided.
// Where the layer by itself fails, so does the output: errors of the rest may hide it in the ladder. More is
// not asked of it, for an error that begins with t^n has any slope there.
void judge(OutputVerdict& output);

// Weighs the guaranteed order against the claim. A claim above it fails if it is refuted; if open, it is
// undecided unless the ladder makes it fail. A guaranteed claim must still be confirmed by the ladder.
void weigh(OutputVerdict& output, const Guarantee& guarantee);

// Holds the estimated maxima against the true ones, on the two smallest usable rungs: estimate_ratio is that
// of the two which is farther from 1. Where it is not within 1/3 ... 3, or there is none, estimate->reason
// says why, as far as a test tells that does not read the ladder.
void weigh_estimate(OutputVerdict& output, ErrorEstimate estimate);

// The estimate at the smallest usable rung, else at the smallest; nullptr: there is none.
const EstimatedRung* told_estimate(const OutputVerdict& output);

// Whatever the ladder shows, the verdict is undecided, with this reason.
void leave_open(OutputVerdict& output, std::string reason);

// The last local slopes are close to one integer and have stopped moving: smaller eps teach nothing.
bool settled(const OutputVerdict& output);

} // namespace resonform
