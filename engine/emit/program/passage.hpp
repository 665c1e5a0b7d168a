// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves a mode its digits where Re lambda = mu changes its sign (solve/flow/passage.hpp).
#pragma once

#include "emit/program/flow_moment.hpp"
#include "solve/solution.hpp"

#include <vector>

namespace resonform {

struct Passage {
    std::size_t mode;
    Graph::Node ratio;       // of one power of the mode in the map to the one before, at the start
    Graph::Node exponential; // e^chi
};

// Each is a list of nodes at any slow time, one of which must be > 0, else digits are lost:
//
//   -mu_0 > 0  or  mu > 0                         what grows first is not believed when it has come back
//   -mu > 0  or  -mu' > 0  or  10^3 |g| sqrt(2 pi/|lambda'|) e^B < eps^w    the buffer point is far; if
//   something drives z mu^{4N + 2} > 4 (r e^chi)^4 mu_0^{4N + 2}     if monomials are divided by mu: near its
//   zero they are gone
//
// now, start: everything at any slow time, and at t = 0.
std::vector<std::vector<Graph::Node>> precision_of(Program& program, const Solution& solution,
                                                   const RealForm& real, const Passage& passage,
                                                   FlowMoment& now, FlowMoment& start);

} // namespace resonform
