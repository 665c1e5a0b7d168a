// SPDX-License-Identifier: GPL-3.0-or-later
// A real polynomial of the normal form by the angles and exponents that its terms turn and decay with, in the
// frame of a slow flow:
//
//   p = sum_d e^{d.chi} (p_{0,d} + sum_k (p_{k,d} + conjugate)),   p_{k,d} = A_{k,d} e^{i k.theta}
#pragma once

#include "solve/flow/slow_flow.hpp"

#include <vector>

namespace resonform {

struct FlowHarmonic {
    std::vector<int> turns;  // k, one for each phase of the flow; the first that is not 0 is positive
    std::vector<int> decays; // d >= 0, one for each exponent of the flow
    Polynomial part;         // p_{k,d}, in the ring of the normal form

    [[nodiscard]] bool turns_not() const; // k = 0
    [[nodiscard]] bool lasts() const;     // d = 0
};

// p_{0,0} first if there is one, then by |k| + |d|. Terms whose angles have the same rate are one harmonic:
// all phases begin at 0. Precondition: p is real.
std::vector<FlowHarmonic> flow_harmonics(const GradedField& field, const SlowFlow& flow, const Polynomial& p);

} // namespace resonform
