// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a right-hand side is that of a single linear oscillator,
//
//   u' = v,  v' = -omega(s)^2 u - 2 gamma(s) v,  s' = constant,
//
// for which there are methods whose cost does not grow with the frequency.
#pragma once

#include "verify/integrate/integrator.hpp"
#include "verify/integrate/tape.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace resonform {

struct LinearOscillator {
    std::size_t u, v; // states
};

// nullopt: it is not, or that cannot be seen from its operations; or its coefficients are data, whose
// breakpoints such methods would have to stop at.
std::optional<LinearOscillator> linear_oscillator(const Tape& rates);

// omega^2 and gamma as functions of t.
class OscillatorCoefficients {
public:
    struct At {
        double square, damping; // omega^2, gamma
    };

    // Precondition: f has a Jacobian, and is that of the oscillator.
    OscillatorCoefficients(RightHandSide f, LinearOscillator oscillator, const std::vector<double>& start);

    [[nodiscard]] At at(double t);
    // A state that is neither u nor v.
    [[nodiscard]] double slow(std::size_t state, double t) const { return start_[state] + rates_[state] * t; }

private:
    RightHandSide f_;
    LinearOscillator oscillator_;
    std::vector<double> start_, rates_, state_, matrix_; // with u = v = 0, on which no slope depends
};

} // namespace resonform
