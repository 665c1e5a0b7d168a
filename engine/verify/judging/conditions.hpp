// SPDX-License-Identifier: GPL-3.0-or-later
// The conditions of every verdict of a ladder: interval, start, times of comparison, and the smallest eps.
#pragma once

#include "model/system/scene_file.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// A ladder goes down to where one run of the direct integration takes more steps than this: about 300,000
// periods, a minute or two in double-double. Steps, not seconds: a verdict is the same on every machine.
constexpr std::size_t most_ladder_steps = 2'000'000;

struct LadderEnd {
    Rational eps; // the first that is left out
    std::string reason;
};

struct Conditions {
    std::string interval, promised;     // "1/eps", "1/eps^2": as measured, as time_scale promises
    bool shorter_than_promised = false; // at one of the eps
    std::vector<std::pair<std::string, std::string>> functions; // omega(tau) and what the scene gives it
    std::vector<std::pair<std::string, std::string>> start;     // as the scene spells it

    // The times of comparison, half of them evenly spread.
    std::size_t count = 0;                                   // at the smallest eps
    double first = std::numeric_limits<double>::quiet_NaN(); // the least above 0, at the smallest eps
    double per_fast_period = std::numeric_limits<double>::quiet_NaN(); // even ones, where they are the fewest

    // Without transients: where the times begin, at the smallest eps, and the eps whose interval is hardly
    // longer than that.
    double layer_end = 0;
    std::vector<Rational> within_layer;

    // Where modes grow, all at the smallest eps: the time at which the comparison with direct integration
    // ends; a line for the reader on what judges later times; the start values that a projection has changed,
    // and that which follows from a mode at 0.
    std::optional<double> growth_end;
    struct Moved {
        std::string state;
        std::optional<double> given;
        double start;
    };
    std::vector<Moved> moved;
    std::string beyond;

    std::optional<LadderEnd> ladder_end;
};

// All but the times and the end.
Conditions conditions_of(const Scene& scene);

// "on t <= eps ONLY, shorter than 1/eps as promised", beside every verdict; "" where it is not.
std::string shortness(const Conditions& conditions);

} // namespace resonform
