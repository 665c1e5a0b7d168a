// SPDX-License-Identifier: GPL-3.0-or-later
// Liars: one coefficient of a scene after the other is changed, and the checks of `verify` are asked. What
// they let pass though it changes an output is a hole in them (docs/design/30_liars.md).
#pragma once

#include "model/exact/first_order_system.hpp"
#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"
#include "verify/judging/options.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

struct Lie {
    std::string output;  // that with the largest effect; "": nothing was computed
    std::string where;   // "map, mode 0, weight 3, term 2"; "outputs: Real(3) / Real(8)"
    std::string planted; // "sign": the other one; "2^-20": times 1 + 2^-20
    double effect_ulp =
        std::numeric_limits<double>::quiet_NaN(); // the largest found, up to where it is caught; NaN: none
    std::string caught_by = {}; // "certificate", "ladder", "emitted = exact"; "": by nothing
};

struct Lies {
    double threshold = 0; // ulp, of emitted = exact
    std::vector<Lie> all;
    // The code fails its check even before a lie is planted, so that being caught proves nothing.
    bool honest_fails = false;

    // An effect of more is to be caught: twice the threshold.
    [[nodiscard]] double clear_of_threshold() const { return 2 * threshold; }
    // What is caught by nothing is below that, or a survivor.
    [[nodiscard]] bool is_below(const Lie& lie) const;
    [[nodiscard]] bool survives(const Lie& lie) const { return lie.caught_by.empty() && !is_below(lie); }
    [[nodiscard]] std::size_t survivors() const;
};

// In every coefficient of normal form and map, with the other sign; for the certificate.
std::vector<Lie> lies_in_formulas(const Normalization& normalization);

// Below, lies are added; lies.threshold is set.

// In every coefficient of the code that `generate` writes, compiled once, in double; for emitted = exact. The
// effect is that at the points of the check.
void lies_in_emitted(const Scene& scene, const Solution& solution, const VerifyOptions& options, Lies& lies);

// In every coefficient of a slow flow, likewise (solve/flow_certificate.hpp).
std::vector<Lie> lies_in_flow(const Solution& solution);

// Changes the sign of each coefficient of a solution in closed form: in its outputs and in the rates and
// quadratures behind them. The ladder is asked, with interpreted code, and stops at the first rung at which
// an output fails.
void lies_in_solution(const std::shared_ptr<const FirstOrderSystem>& system, const Scene& scene,
                      const Solution& solution, const VerifyOptions& options, Lies& lies);

// All of them. Code is compiled, whatever the options say.
Lies liars(const std::shared_ptr<const FirstOrderSystem>& system, const Scene& scene,
           const Solution& solution, const VerifyOptions& options);

// The table of `resonform verify --liars`.
std::string to_text(const Lies& lies);

} // namespace resonform
