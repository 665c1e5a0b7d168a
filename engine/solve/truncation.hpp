// SPDX-License-Identifier: GPL-3.0-or-later
// How far normal form and map must be computed for a solution of order N on t <= T/eps^p (design 2.4).
#pragma once

#include "expand/expansion/graded_field.hpp"
#include "model/system/scene_file.hpp"

#include <string>

namespace resonform {

// M, and the count that led to it as one sentence for the user.
struct TruncationCount {
    int truncation;
    std::string reason;
};

// The scene's own `truncation` ("plain truncation"); otherwise, for time_scale p, all in units of the least
// weight 1/q (docs/design/29_rational_weights.md), where eps^p is p q of them,
//
//   M = max(N + p, N + 2p - 2)   with an oscillator: rates neglected at weight M + 1 act
//                                over eps^-p on amplitude, phase and drift, and by the twist eps^2
//                                delta^2 of the frequency once more on the phase;
//   M = N + p                    without one;
//   M = max(N + p, N + 2p - 1)   for several, finite ones or angles: amplitudes of any kind act on the
//                                phases at order eps; and where a drift is an output: on it at eps^2;
//   M = N + 2p - w               at least, where slow variables are driven: through their frequencies they
//                                act on phases at once, and these on outputs of weight w;
//   M = N + p                    without lasting phases: where all modes are damped (or of eigenvalue 0).
//
// Errors: refused where a slow variable xi' = eps^n c, n < p, leaves every compact set, so that the count
// does not hold; refused for M > 99.
TruncationCount count_truncation(const GradedField& field, const Scene& scene);

} // namespace resonform
