// SPDX-License-Identifier: GPL-3.0-or-later
// The estimated error of each output along a ladder of eps: maxima over the interval.
#pragma once

#include "verify/estimate/best_order.hpp"
#include "verify/estimate/next_weight.hpp"

#include <map>
#include <string>
#include <vector>

namespace resonform {

struct EstimatedRung {
    Rational eps;
    double map = 0, flow = 0, error = 0; // max |map|, |flow|, |flow + map|; infinite: no numbers somewhere
    double rounding = 0;                 // of `error`
};

struct ErrorEstimate {
    int next_order = 0;                // N' of error_estimator.hpp; 0: there is none
    std::string reason;                // why
    std::vector<EstimatedRung> ladder; // eps as given
    std::vector<BestOrder> best;       // where one is known; none of a mean motion, or where next_order is 0
};

using ErrorEstimates = std::map<std::string, ErrorEstimate>; // by output

// Errors: those of ErrorEstimator.
ErrorEstimates error_estimates(const Scene& scene, const Solution& solution, const std::vector<Rational>& eps,
                               const Derive& derive);

} // namespace resonform
