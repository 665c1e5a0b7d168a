// SPDX-License-Identifier: GPL-3.0-or-later
// Amplitude and phase of one oscillator in normal form, w = Delta e^{i theta}:
//
//   w' = w sum a_kc(xi) |w|^(2k) eps^c
//   d log Delta/dt = sum Re a_kc Delta^(2k) eps^c,   theta' = sum Im a_kc Delta^(2k) eps^c
//
// Pendulum: d log Delta/dt = -xi xi'/(4 (xi^2 + r^2)), Delta = eps C (xi^2 + r^2)^(-1/8)    (21)
#pragma once

#include "solve/substitution.hpp"

#include <vector>

namespace resonform {

// The leading envelope E = exp int Re a_01 dT, before the ring of the solution exists: the part of
// Re a_01 that is a logarithmic derivative of powers of the ring's roots, and the rest.
//   E = prod base^(exponent) exp int rest dT
struct EnvelopePlan {
    struct Power {
        GeneratorId base; // a root of the normal form's ring, or the positive slow variable
        Rational exponent;
    };
    std::vector<Power> powers;
    Polynomial rest;
    [[nodiscard]] std::vector<Refinement> refinements() const;
};

// Errors (refused): Re a_00 != 0 (damping at weight 0 leaves no oscillation on 1/eps).
EnvelopePlan plan_envelope(const NormalForm& normal_form);

// Is every a_kc imaginary, so that no rate changes the modulus? true without a mode.
bool amplitude_is_constant(const NormalForm& normal_form);

// Fills envelope, then factor 1 + eps B_1 + ... + eps^(M-2) B_(M-2) from rates of weight <= M, then
// theta' = sum_n eps^n Theta_n, n <= M-1, of the draft's mode. No mode: nothing.
void solve_amplitude_and_phase(Draft& draft, const EnvelopePlan& plan);

} // namespace resonform
