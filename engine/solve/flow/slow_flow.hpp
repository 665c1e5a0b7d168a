// SPDX-License-Identifier: GPL-3.0-or-later
// The normal form as a slow flow, in a frame of phases that obeys the resonance relations:
//
//   z_j = eps^w a_j e^{i theta_j},   theta_j' = omega_j(zeta),
//   a_j' = (N_j - i omega_j z_j)/(eps^w e^{i theta_j}),   zeta' = N,   Z' = N
//
// Every monomial of N_j turns with theta_j, so that in the new variables nothing fast is left: an evaluator
// solves this once, in slow time T = eps t, with large steps, and adds the phases (design 2.5). Amplitudes
// stay complex: polar coordinates break down where one passes zero.
//
// Where no rate changes a modulus, N_j = i (omega_j + Theta_j(|z|^2)) z_j, the phases take all of it,
// theta_j' = omega_j + Theta_j, and every a_j is a constant: then nothing is left to be solved. Of rational
// weights Theta_j may weigh less than eps, so that a_j would turn fast in slow time: the phases take such
// terms at least, with moduli that the flow moves, unless the frame would not obey the resonance relations.
//
// A mode that is damped at eps = 0 also decays within the frame (and one with Re lambda_s > 0 grows),
//
//   z_s = eps^w a_s e^{chi_s + i theta_s},   chi_s' = Re lambda_s + ...,   theta_s' = Im lambda_s + ...
//
// where the exponents take its whole rate, N_s = (lambda_s + Lambda_s) z_s with Lambda_s free of damped
// modes: a_s is a constant then. If products of damped modes stay in some rate, exponents take lambda_s
// alone, and such products must decay exactly as the mode that they drive. A real mode has no phase; one of
// eigenvalue 0 has neither phase nor exponent. Where the sign of Re lambda_s is not declared, the start
// decides between decay and growth, and some modes may change it (solve/flow/passage.hpp).
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <optional>
#include <string>
#include <vector>

namespace resonform {

// Series are in the ring of the normal form, in which z stands for z_j and e^{i phi} for an angle.
struct FlowMode {
    std::optional<std::size_t> phase; // theta_j: index into SlowFlow::phases; angles and complex modes
    std::optional<std::size_t> decay; // chi_j: index into SlowFlow::decays; damped modes
    Series rate;         // the rate of z_j within the frame; of an angle: phi' - theta'. Empty: a constant
    bool grows = false;  // at eps = 0, as its system declares
    bool either = false; // decays or grows: not declared, and not left out
    bool passes = false; // either, and Re lambda may vanish (solve/flow/passage.hpp)
    bool is_left_out = false; // a damped or growing mode, by SolveOptions: in no output and no rate
    bool is_at_zero = false;  // by [start], and left out therefore
    // For certain, so that its rate matters on times of order 1 only: through weight N, that of the term.
    [[nodiscard]] bool decays(const Mode& mode) const { return mode.is_damped() && !grows && !either; }
    // -Re lambda of a damped mode, Re lambda of one that grows: > 0 as long as it does. Of one that does
    // either: it keeps the sign of the start, unless it passes.
    [[nodiscard]] Polynomial leading_rate(const Mode& mode) const {
        return grows ? mode.growth : -mode.growth;
    }
};

struct FlowOutput {
    std::string name;                 // "x", "x'", "xi"
    std::size_t variable;             // index into System::variables
    Series value;                     // by weight
    std::optional<std::size_t> drift; // index into SlowFlow::drift: Z is to be added
};

struct SlowFlow {
    std::vector<Polynomial> phases;  // theta', different from each other: real, without whole harmonics
    std::vector<Polynomial> decays;  // chi', different from each other: real, without whole harmonics
    std::vector<FlowMode> modes;     // one for each of GradedField::modes
    std::vector<FlowMode> angles;    // one for each of GradedField::angles
    std::vector<Series> slow, drift; // their rates
    std::vector<FlowOutput> outputs; // every variable of the system but angles, cut at the order
    // Every state but slow variables and angles, at the full weight. Where a mode may grow, with the slow
    // variables and without the modes that are left out: the state on the manifold.
    std::vector<FlowOutput> state;

    // Some mode grows at eps = 0, or may.
    [[nodiscard]] bool grows() const;
    [[nodiscard]] bool may_grow() const;
    // A mode that grows, or may, is not left out.
    [[nodiscard]] bool follows_growth() const;
    // The start is moved along the fibres to where the mode that grows is 0.
    [[nodiscard]] bool is_projected() const;
    // No mode, angle or slow variable has a rate within the frame.
    [[nodiscard]] bool at_rest() const;
};

// The net phase of a monomial of the normal form's ring: <alpha, theta'>; empty: it does not oscillate.
Polynomial net_rate(const GradedField& field, const SlowFlow& flow, const Monomial& monomial);

// The net exponent's rate of a monomial: <|alpha|, chi'>; empty: it does not decay.
Polynomial net_decay(const GradedField& field, const SlowFlow& flow, const Monomial& monomial);

// Whether a monomial of a rate is z_k times powers of moduli; k = nullopt: powers of moduli only. Real modes
// are not looked at.
bool turns_as(const GradedField& field, const Monomial& monomial, std::optional<std::size_t> k);

// Whether a mode is known to grow at eps = 0, Re lambda > 0 as its system declares.
bool grows(const GradedField& field, std::size_t k);

// Whether p is a multiple of Re lambda of a mode that passes: a divisor of its monomials that may vanish.
bool passes_zero(const SlowFlow& flow, const GradedField& field, const Polynomial& p);

// How often a mode and its conjugate occur in a monomial.
int degree_in(const GradedField& field, const Monomial& monomial, std::size_t k);

// Whether a monomial contains a mode that decays (or grows): soon nothing is left of it (or of the rest).
bool has_damped_mode(const GradedField& field, const Monomial& monomial);

// p without its oscillating and decaying terms.
Polynomial mean_part(const GradedField& field, const SlowFlow& flow, const Polynomial& p);

// The weight of the first oscillating or decaying term of an output; nullopt: it has none.
std::optional<int> first_oscillation(const GradedField& field, const SlowFlow& flow,
                                     const std::string& output);

// nullopt: every part is empty.
std::optional<int> lowest_weight(const Series& series);

// The lowest power of eps in a_j'/a_j or zeta': the flow moves on the time scale eps^-power. Where no rate
// depends on a phase, the rates of phases do not count, only those of moduli and slow variables. Damped modes
// do not count: they are gone before. nullopt: at rest.
std::optional<int> flow_power(const GradedField& field, const SlowFlow& flow);

} // namespace resonform
