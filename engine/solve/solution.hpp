// SPDX-License-Identifier: GPL-3.0-or-later
// The solution of a normal form. With one small oscillator (or none) and slow variables of explicit law it is
//
//   xi = xi_0 + eps v t,  w = Delta e^{i theta},  Delta = eps C E(xi) (1 + eps^2 B_2(xi) + ...)   (21)
//   theta = theta_0 + int_0^t (omega(xi) + eps^2 Theta_2(xi) + ...) dt
//   z_X = C_X + closed primitives + quadratures from xi_0
//   psi, x, y = the map with all this put in, by powers of eps through N                    (22), (23)
//
// Everything is a Polynomial of the solution ring: the ring of the normal form without its modes,
// roots refined (sigma -> s^(1/8)), plus the constants of the solution, e^{i theta}, and primitives.
//
// A slow variable may relax instead (solve/slow_law.hpp). With several oscillators, finite ones, slow
// variables of other laws, or angles it is the slow flow (solve/flow/slow_flow.hpp), in the ring of the
// normal form.
#pragma once

#include "normalize/recursion/normal_form.hpp"
#include "solve/flow/slow_flow.hpp"
#include "solve/flow/solve_options.hpp"
#include "solve/slow_law.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

enum class PrimitiveKind {
    logarithm,   // log(argument), argument positive, vanishing at xi = 0 where that is possible
    quadrature,  // int_{xi_0}^{xi} argument d xi, or int_0^T argument dT with T = eps t
    exponential, // exp(argument)
};

struct Primitive {
    GeneratorId id;   // in Solution::ring
    std::string name; // "Q_x2", "L1"
    PrimitiveKind kind;
    Polynomial argument;         // in Solution::ring
    bool over_slow_time = false; // in terms of T = eps t: its derivative by xi is no element of the ring
};

struct SlowLaw {           // xi' = eps rate
    std::size_t variable;  // index into system.variables
    GeneratorId generator; // in Solution::ring
    Polynomial rate;       // a - b xi with a and b of parameters only
    SlowPath path;         // a and b
};

struct ModeSolution {
    std::size_t variable;
    GeneratorId amplitude;                  // C_delta: Delta = eps * C_delta * E * ...
    std::string amplitude_name, phase_name; // "C_delta", "theta_0" (the user's notation)
    GeneratorId phase;                      // e^{i theta}
    Polynomial envelope;                    // E(xi), e.g. (xi^2 + r^2)^(-1/8)
    Series factor;                          // 1 + eps^2 B_2 + ..., by weight (powers of eps)
    Series phase_rate; // theta' = sum_n eps^n Theta_n(xi), weights 0 ... ; part(n) holds eps^n
};

struct DriftSolution {
    std::size_t variable;
    GeneratorId constant; // C_X
    std::string constant_name;
    Series value; // z_X by powers of eps, the constant included in part 0
};

struct SolutionOutput {
    std::string name; // "psi", "x", "psi'" ...
    Series value;     // part(n) is the factor with eps^n in it; in e^{i theta}, primitives, ...
};

struct Solution {
    std::shared_ptr<const Normalization> normalization;
    int order = 0;                        // N: outputs are cut at eps^N
    int truncation = 0;                   // M: normal form and map are used through M
    std::shared_ptr<const SlowFlow> flow; // if set, it is the solution, and all below is empty
    RingPtr ring;
    std::shared_ptr<const RingMap> from_normal_form; // for polynomials free of modes: sigma -> rho^2, ...
    GeneratorId eps;
    std::vector<SlowLaw> slow;            // none or one
    std::optional<GeneratorId> slow_time; // T = eps t: in the ring if no slow variable moves evenly
    std::vector<ModeSolution> modes;      // none or one
    std::vector<DriftSolution> drift;
    std::vector<Primitive> primitives;   // a primitive uses only earlier ones
    std::vector<SolutionOutput> outputs; // every fast and drift variable of the system, file order
    // Every state of the first-order system but the slow ones ("psi", "psi'", "x", "y"), with the map
    // at its full weight M: the initial values of a direct integration are these at t = 0.
    std::vector<SolutionOutput> state;
    // The drift variables without oscillation are the parts of `outputs` free of e^{i theta}.

    [[nodiscard]] const System& system() const { return normalization->normal_form.field->system(); }
};

// The power of eps of the first oscillating term of an output. nullopt: it has none through the order.
[[nodiscard]] std::optional<int> first_oscillation(const Solution& solution, const std::string& output);

} // namespace resonform
