// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/passage.hpp"

#include "model/signs/sign_prover.hpp"

#include <algorithm>

namespace resonform {

namespace {

// zeta' = a constant of its own.
bool moves_evenly(const GradedField& field, const SlowVariable& slow) {
    return !slow.driven && !moves_slowly(field, slow.rate);
}

bool is_linear(const GradedField& field, const Polynomial& p) {
    return std::none_of(field.slow.begin(), field.slow.end(), [&](const SlowVariable& slow) {
        return moves_slowly(field, field.ring->derivative(p, slow.generator));
    });
}

// In slow variables: of coefficients that have no singularity at complex times.
bool has_polynomial_rates(const GradedField& field) {
    const std::vector<State>& states = field.first_order->states;
    return std::all_of(states.begin(), states.end(), [&](const State& state) {
        return std::all_of(field.slow.begin(), field.slow.end(), [&](const SlowVariable& slow) {
            const GiNaC::symbol& zeta = states[field.first_order->index(slow.variable, 0)].symbol;
            return state.rate.is_polynomial(zeta) && state.shift.is_polynomial(zeta);
        });
    });
}

} // namespace

bool has_either_sign(const GradedField& field, std::size_t k) {
    const GiNaC::ex& growth = field.basis.modes[k].eigenvalue.re;
    return field.modes[k].is_damped() && !provably_positive(growth, field.system()) &&
           !provably_positive(-growth, field.system());
}

bool may_pass_zero(const GradedField& field, std::size_t k) {
    const Mode& mode = field.modes[k];
    if (mode.is_real() || !has_either_sign(field, k)) return false;
    if (!moves_slowly(field, mode.growth)) return true;
    const auto evenly = [&](const SlowVariable& slow) { return moves_evenly(field, slow); };
    return field.modes.size() == 1 && field.angles.empty() &&
           std::all_of(field.slow.begin(), field.slow.end(), evenly) && is_linear(field, mode.growth) &&
           is_linear(field, mode.omega) && has_polynomial_rates(field);
}

bool moves_slowly(const GradedField& field, const Polynomial& p) {
    return std::any_of(field.slow.begin(), field.slow.end(), [&](const SlowVariable& slow) {
        return !field.ring->derivative_known(p, slow.generator) ||
               !field.ring->derivative(p, slow.generator).empty();
    });
}

Polynomial slope_in_time(const GradedField& field, const Polynomial& p) {
    std::vector<Polynomial> addends;
    for (const SlowVariable& slow : field.slow)
        addends.push_back(field.ring->multiply(field.ring->derivative(p, slow.generator), slow.rate));
    return sum(addends);
}

bool are_proportional(const Polynomial& p, const Polynomial& q) {
    if (p.empty() || q.empty()) return false;
    const Rational factor = p.terms().front().coefficient / q.terms().front().coefficient;
    return p == factor * q;
}

bool is_multiple_of_growth(const GradedField& field, std::size_t k, const Polynomial& p) {
    return are_proportional(p, field.modes[k].growth);
}

} // namespace resonform
