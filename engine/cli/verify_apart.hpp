// SPDX-License-Identifier: GPL-3.0-or-later
// What `verify` derives beyond the scene, in processes of their own: where a derivation meets its limits, the
// ladder's results are kept.
#pragma once

#include "cli/watch.hpp"
#include "verify/estimate/error_estimate.hpp"
#include "verify/judging/guarantee.hpp"

#include <vector>

namespace resonform {

Guarantees guarantees_apart(const Scene& scene, const Solution& solution, const Claims& claims,
                            DerivationLimits limits);

// Where the next weight cannot be derived, each output has the reason instead.
ErrorEstimates error_estimates_apart(const Scene& scene, const Solution& solution,
                                     const std::vector<Rational>& eps, DerivationLimits limits);

} // namespace resonform
