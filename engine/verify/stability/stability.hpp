// SPDX-License-Identifier: GPL-3.0-or-later
// The stability sweep: the emitted evaluator in double against the exact solution in 50 digits, over many
// decades of every input, corners included; errors in ulp of the output's scale.
#pragma once

#include "verify/judging/ladder.hpp"
#include "verify/stability/by_decade.hpp"
#include "verify/stability/lost_digits.hpp"
#include "verify/stability/points.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

using NamedInputs = std::vector<std::pair<std::string, double>>; // eps, parameters, start values, t

struct WorstPoint {
    std::string output;
    double ulp = 0; // infinite: a number where the exact solution has none
    // Of it, if above the threshold: the effect of a last bit of the inputs, added up: that is the condition
    // number, too. And of a last bit of the slow time alone.
    double unavoidable = 0, by_slow_time = 0;
    std::string sensitive_to; // the input of which a last bit does most; "" where unavoidable is 0
    NamedInputs at;
    std::optional<LostDigits> lost = {}; // of the worst of an output: which part of it loses them

    // Of a condition number of 1e8 and more, where half of the digits of double are gone.
    [[nodiscard]] bool is_ill_conditioned() const;
    // by_slow_time; of a condition number of 1e8 and more: unavoidable.
    [[nodiscard]] double left_open() const;
    // Above threshold (1 + left_open()).
    [[nodiscard]] bool is_wrong(double threshold) const;
};

// Points that were answered by one status for one cause.
struct StabilityRefusals {
    std::string status, why; // why: the quantity that the evaluator names, "" if none
    std::size_t count = 0, unexplained = 0;
    std::vector<SweptInput> where = {}; // the ranges of the inputs there
    double first_t = 0, last_t = 0;
    NamedInputs first = {}; // of those without an explanation
};

// How many errors lie up to a power of two, and above the one before; the last one infinite where an
// evaluator has a number and the exact solution none.
struct UlpBin {
    double up_to = 0;
    std::size_t count = 0;
};

struct Stability {
    std::string system, scene;
    std::uint64_t seed = 0;
    double threshold = default_ulp;    // of the scene
    std::string reason;                // why it is more than the default
    std::vector<SweptInput> inputs;    // how far each is to be driven
    std::vector<SweptInput> reachable; // how far it may go by itself in the declared domain
    std::vector<SweptInput> swept;     // how far it was, at points where the exact solution is computed
    Verdict verdict = Verdict::undecided;
    std::string rule;                 // that failed or is left open, with its numbers; empty at a pass
    std::size_t cases = 0;            // each is one of the next four
    std::size_t compared = 0;         // numbers beside numbers
    std::size_t refused = 0;          // the evaluator answered with a status
    std::size_t beyond_reference = 0; // the exact solution is not computed so far
    std::size_t not_judged = 0;       // with an input far beyond
    std::map<std::string, double> not_judged_ulp;             // output -> the worst there
    std::map<std::string, std::size_t> not_judged_refused_by; // status -> how many there
    std::map<std::string, std::size_t> refused_by;            // status -> how many
    std::size_t unexplained = 0; // of `refused`: the exact solution has moderate numbers
    // Errors above the threshold that are not wrong, and those of them with a condition number below 1e8,
    // which the slow time leaves open.
    std::size_t ill_conditioned = 0, moderately_ill_conditioned = 0;
    std::vector<WorstPoint> worst;                      // five of each output: wrong ones first, then by size
    std::vector<StabilityRefusals> refusals;            // the most frequent first
    std::vector<std::pair<std::string, double>> median; // per output, in ulp
    std::vector<std::pair<std::string, std::vector<UlpBin>>> histogram; // per output, from 0.5 ulp on
    std::vector<InputByDecade> by_decade;                               // of `compared` and `refused`
};

struct StabilityOptions : VerifyOptions {
    std::size_t points = 300; // six times from each start
    std::uint64_t seed = 2;
};

constexpr double unexplained_share = 0.01; // with more of the points there is something wrong

// Sweeps all inputs of the program, with [fix] values as free parameters. Verdict: fail, where
// an error is wrong (WorstPoint::is_wrong), or more than a hundredth of the points have an unexplained
// status, due neither to the exact solution (the declared domain, a radicand, a divisor, a start to which the
// map does not lead back) nor a value beyond double nor a large phase; undecided, where less than a tenth of
// them are compared, or fewer than lie beyond the reference, or an input was driven over less than half of
// the decades open to it. Errors: those of bounded_interval_length at the smallest eps of the ladder.
Stability stability(const Scene& scene, const Solution& solution, const StabilityOptions& options);

std::string to_text(const Stability& stability);

} // namespace resonform
