// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of slow variables whose solutions are known:
//
//   xi' = a          xi = xi_0 + a t
//   xi' = a - b xi   xi = xi_0 e^{-bt} + (a/b) (1 - e^{-bt})
#pragma once

#include "algebra/ring/ring.hpp"

#include <optional>

namespace resonform {

// a and b of xi' = a - b xi, free of all that moves. decline: no term, or one that is not zero, so that
// (over a power of eps) the ring has its inverse.
struct SlowPath {
    Polynomial drive, decline;
    [[nodiscard]] bool relaxes() const { return !decline.empty(); }
};

// Of this rate of the slow variable xi. nullopt: it is of another kind, or b is not proved to be nonzero.
[[nodiscard]] std::optional<SlowPath> slow_path(const Ring& ring, GeneratorId xi, const Polynomial& rate);

// An evaluator ends where an exponential of slow time, e^{-bT} here, has fallen to e^{-most_relaxations}: a
// transient that takes a smaller part of the interval could fall between the nodes of a quadrature.
inline constexpr int most_relaxations = 4096;

} // namespace resonform
