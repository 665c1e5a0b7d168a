// SPDX-License-Identifier: GPL-3.0-or-later
// What became of the points of a sweep, decade by decade of each input: the worst errors, and the statuses.
#pragma once

#include "verify/stability/answers.hpp"
#include "verify/stability/points.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

struct Decade {
    std::optional<int> exponent; // 10^exponent <= |value| < 10^(exponent + 1), measured as swept; none: 0
    std::size_t compared = 0;
    std::map<std::string, std::size_t> refused_by = {}; // status -> how many
    std::vector<double> ulp = {};                       // the worst of each output; empty: none is compared

    // 10^exponent, or 0.
    [[nodiscard]] double from() const;
};

struct InputByDecade {
    SweptInput input;
    std::vector<Decade> decades = {}; // 0, then in ascending order; those without a point are left out
};

// In the order of the inputs; t is the last one.
std::vector<InputByDecade> no_decades(const std::vector<SweptInput>& inputs);
// Of a point to which the exact solution is known.
void add(const SweepPoint& at, const StabilityAnswer& answer, std::vector<InputByDecade>& all);

} // namespace resonform
