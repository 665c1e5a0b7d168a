// SPDX-License-Identifier: GPL-3.0-or-later
// The stability sweep: the emitted evaluator in double against the symbolic one in 50 digits, over
// many decades of every input, corners included; errors in ulp of the output's scale.
#pragma once

#include "verify/ladder.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

struct WorstPoint {
    std::string output;
    double ulp = 0;
    std::vector<std::pair<std::string, double>> at; // eps, parameters, start values, t
};

struct Stability {
    std::string system, scene;
    std::size_t cases = 0;
    std::size_t refused = 0;                       // the evaluator answered with a status
    std::map<std::string, std::size_t> refused_by; // status -> how many
    std::size_t beyond_reference = 0;              // 50 digits are not enough or the answer is not finite
    std::vector<WorstPoint> worst;                 // the five worst points of each output
    std::vector<std::pair<std::string, double>> median; // per output, in ulp
};

struct StabilityOptions : VerifyOptions {
    std::size_t random_points = 80; // each at six times
    std::uint64_t seed = 2;
};

// Sweeps what the program of the scene takes, [fix] values included as free parameters: positive ones
// from 1e-12 to 1e12, slow variables to +-1e150 and 0, eps from 1e-12 to 0.5, phases to 1e14.
Stability stability(const Scene& scene, const Solution& solution, const StabilityOptions& options);

std::string to_text(const Stability& stability);

} // namespace resonform
