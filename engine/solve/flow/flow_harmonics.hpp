// SPDX-License-Identifier: GPL-3.0-or-later
// A real polynomial of the normal form by the angles that its terms turn with, in the frame of a slow flow:
//
//   p = p_0 + sum_k (p_k + conjugate),   p_k = A_k e^{i k.theta}
#pragma once

#include "solve/flow/slow_flow.hpp"

#include <vector>

namespace resonform {

struct FlowHarmonic {
    std::vector<int> turns; // k, one for each phase of the flow; the first that is not 0 is positive
    Polynomial part;        // p_k, in the ring of the normal form
};

// p_0 first if there is one, then by |k|. Terms whose angles have the same rate are one harmonic: all phases
// begin at 0. Precondition: p is real, and no term of it decays.
std::vector<FlowHarmonic> flow_harmonics(const GradedField& field, const SlowFlow& flow, const Polynomial& p);

} // namespace resonform
