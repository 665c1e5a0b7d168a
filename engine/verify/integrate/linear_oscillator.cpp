// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/linear_oscillator.hpp"

#include <algorithm>

namespace resonform {

namespace {

// How a register depends on u and v.
enum class Dependence { zero, none, linear, other };

// linear: a sum of such, and products with what does not depend on them.
Dependence dependence_of(const Tape::Instruction& step, Dependence left, Dependence right) {
    using Op = Tape::Op;
    const bool is_binary = step.op <= Op::scale || step.op == Op::divide || step.op == Op::power ||
                           step.op == Op::function || step.op == Op::data;
    if (left <= Dependence::none && (!is_binary || right <= Dependence::none)) return Dependence::none;
    switch (step.op) {
    case Op::add:
    case Op::subtract: // 0 - x, too
        if (left == Dependence::zero) return right;
        return left == right ? left : Dependence::other;
    case Op::multiply:
    case Op::scale:
        if (left <= Dependence::none) return right;
        return right <= Dependence::none ? left : Dependence::other;
    case Op::divide: return right <= Dependence::none ? left : Dependence::other;
    default: return Dependence::other;
    }
}

std::vector<Dependence> dependences(const Tape& rates, LinearOscillator o) {
    std::vector<Dependence> all(static_cast<std::size_t>(rates.size()), Dependence::none);
    const auto at = [&](int r) -> Dependence& { return all[static_cast<std::size_t>(r)]; };
    for (const Tape::Number& number : rates.numbers())
        if (number.value[0] == 0) at(number.target) = Dependence::zero;
    for (const std::size_t state : {o.u, o.v})
        at(rates.constant_count() + static_cast<int>(state)) = Dependence::linear;
    for (const Tape::Instruction& step : rates.body()) {
        const Dependence found = dependence_of(step, at(step.left), at(step.right));
        at(step.result) = found;
        if (has_two_results(step.op)) at(step.result + 1) = found;
    }
    return all;
}

} // namespace

std::optional<LinearOscillator> linear_oscillator(const Tape& rates) {
    if (!rates.data().empty()) return std::nullopt;
    std::optional<LinearOscillator> found;
    std::size_t constant = 0;
    const auto states = static_cast<std::size_t>(rates.state_count());
    for (std::size_t i = 0; i < states; ++i) {
        const int rate = rates.outputs()[i];
        if (rate < rates.constant_count())
            ++constant;
        else if (rate < rates.constant_count() + rates.state_count() && !found)
            found = LinearOscillator{i, static_cast<std::size_t>(rate - rates.constant_count())};
    }
    if (!found || found->u == found->v || constant + 2 != states) return std::nullopt;
    const int rate = rates.outputs()[found->v];
    return rate >= rates.constant_count() &&
                   dependences(rates, *found)[static_cast<std::size_t>(rate)] == Dependence::linear
               ? found
               : std::nullopt;
}

OscillatorCoefficients::OscillatorCoefficients(RightHandSide f, LinearOscillator oscillator,
                                               const std::vector<double>& start)
    : f_(f), oscillator_(oscillator), start_(start), rates_(start.size()), state_(start.size()),
      matrix_(start.size() * start.size()) {
    start_[oscillator_.u] = start_[oscillator_.v] = 0;
    f_.call(f_.context, start_.data(), rates_.data());
    rates_[oscillator_.u] = rates_[oscillator_.v] = 0;
}

OscillatorCoefficients::At OscillatorCoefficients::at(double t) {
    for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = slow(i, t);
    f_.jacobian(f_.context, state_.data(), matrix_.data());
    const auto slope = [&](std::size_t by) { return matrix_[by * state_.size() + oscillator_.v]; };
    return {-slope(oscillator_.u), -slope(oscillator_.v) / 2};
}

} // namespace resonform
