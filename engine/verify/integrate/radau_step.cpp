// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/radau_step.hpp"

#include "verify/run/real.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

constexpr int most_iterations = 20;
// Of an iteration's change to the one before: above `slow` the matrix is made anew; above `stalled` an
// iteration that gets nowhere, which is at its end if its changes are rounding errors; above `diverging` a
// bad guess.
constexpr double slow = 1e-2, stalled = 0.25, diverging = 2;
constexpr double safety = 1e-3;        // Newton's error at its end, in units of the tolerance
constexpr double rounding_errors = 64; // in each rate, and in its way through the matrix

// 1 for a state that has been zero all the time.
double unit_of(double scale) { return scale > 0 ? scale : 1; }

} // namespace

template <class Real>
RadauStep<Real>::RadauStep(const Tape& tape, const std::vector<Real>& parameters, const Real& eps,
                           const RadauRule<Real>& rule, double tolerance)
    : tape_(tape, parameters, eps), jacobian_(tape, convert_all<double>(parameters), to_double_value(eps)),
      rule_(rule), tolerance_(tolerance), states_(static_cast<std::size_t>(tape.state_count())),
      matrix_(states_ * states_), steepest_(states_ * states_), stage_rates_(rule.stages * states_, Real(0)),
      residuals_(rule.stages * states_, Real(0)), changes_(states_), noise_(states_) {}

template <class Real> bool RadauStep<Real>::rates(const std::vector<Real>& state, std::vector<Real>& rates) {
    ++evaluations_;
    tape_.evaluate(state.data(), rates.data());
    return std::all_of(rates.begin(), rates.end(),
                       [](const Real& rate) { return std::isfinite(to_double_value(rate)); });
}

template <class Real> const std::vector<double>& RadauStep<Real>::jacobian(const std::vector<Real>& state) {
    jacobian_.evaluate(convert_all<double>(state).data(), matrix_.data());
    return matrix_;
}

template <class Real>
bool RadauStep<Real>::solve(const std::vector<Real>& state, const Real& h, std::vector<Real>& increments,
                            std::vector<double>& scales) {
    const double length = to_double_value(h);
    const std::vector<double> scales_so_far = scales;
    double before = std::numeric_limits<double>::infinity(), ratio = 1;
    for (int k = 0; k < most_iterations; ++k) {
        scales = scales_so_far;
        raise(scales, state, increments);
        if (!residuals(state, h, increments)) return false;
        const bool anew =
            k == 0 || (k == 1 ? before : ratio) > slow; // the first change tells how far f' is off
        if (anew && !decompose(state, length, increments, scales)) return false;
        improve(increments, scales);
        double change = 0;
        for (std::size_t a = 0; a < states_; ++a) change = std::max(change, changes_[a] / unit_of(scales[a]));
        ratio = change / before;
        const Outcome outcome = judge(k, change, ratio, length, scales);
        if (outcome != Outcome::go_on) return outcome == Outcome::converged;
        before = change;
    }
    return false;
}

template <class Real>
void RadauStep<Real>::raise(std::vector<double>& scales, const std::vector<Real>& state,
                            const std::vector<Real>& increments) const {
    for (std::size_t j = 0; j < rule_.stages; ++j)
        for (std::size_t a = 0; a < states_; ++a)
            scales[a] =
                std::max(scales[a], std::abs(to_double_value(Real(state[a] + increments[j * states_ + a]))));
}

template <class Real>
bool RadauStep<Real>::residuals(const std::vector<Real>& state, const Real& h,
                                const std::vector<Real>& increments) {
    std::vector<Real> stage(states_), rate(states_);
    for (std::size_t j = 0; j < rule_.stages; ++j) {
        for (std::size_t a = 0; a < states_; ++a) stage[a] = state[a] + increments[j * states_ + a];
        if (!rates(stage, rate)) return false;
        std::copy(rate.begin(), rate.end(), stage_rates_.begin() + static_cast<std::ptrdiff_t>(j * states_));
    }
    for (std::size_t i = 0; i < rule_.stages; ++i)
        for (std::size_t a = 0; a < states_; ++a) {
            Real sum(0);
            for (std::size_t j = 0; j < rule_.stages; ++j)
                sum += rule_.matrix[i * rule_.stages + j] * stage_rates_[j * states_ + a];
            residuals_[i * states_ + a] = increments[i * states_ + a] - h * sum;
        }
    return true;
}

// I - h a_ij f'_ab(Y_j), times the scale of b, divided by that of a.
template <class Real>
bool RadauStep<Real>::decompose(const std::vector<Real>& state, double h, const std::vector<Real>& increments,
                                const std::vector<double>& scales) {
    const std::size_t size = rule_.stages * states_;
    std::vector<double> whole(size * size, 0.0);
    std::vector<Real> stage(states_);
    std::fill(steepest_.begin(), steepest_.end(), 0.0);
    for (std::size_t j = 0; j < rule_.stages; ++j) {
        for (std::size_t a = 0; a < states_; ++a) stage[a] = state[a] + increments[j * states_ + a];
        const std::vector<double>& slopes = jacobian(stage);
        for (std::size_t k = 0; k < slopes.size(); ++k)
            steepest_[k] = std::max(steepest_[k], std::abs(slopes[k]));
        for (std::size_t i = 0; i < rule_.stages; ++i) {
            const double factor = h * to_double_value(rule_.matrix[i * rule_.stages + j]);
            for (std::size_t a = 0; a < states_; ++a)
                for (std::size_t b = 0; b < states_; ++b)
                    whole[(i * states_ + a) * size + j * states_ + b] =
                        -factor * slopes[a * states_ + b] * (unit_of(scales[b]) / unit_of(scales[a]));
        }
    }
    for (std::size_t k = 0; k < size; ++k) whole[k * size + k] += 1;
    return lu_.factor(whole);
}

template <class Real>
void RadauStep<Real>::improve(std::vector<Real>& increments, const std::vector<double>& scales) {
    std::vector<double> correction(residuals_.size());
    for (std::size_t k = 0; k < correction.size(); ++k)
        correction[k] = to_double_value(residuals_[k]) / unit_of(scales[k % states_]);
    lu_.solve(correction);
    std::fill(changes_.begin(), changes_.end(), 0.0);
    for (std::size_t k = 0; k < correction.size(); ++k) {
        const double change = correction[k] * unit_of(scales[k % states_]);
        increments[k] -= Real(change);
        changes_[k % states_] = std::max(changes_[k % states_], std::abs(change));
    }
}

// The error that is left is the change times ratio/(1 - ratio) (Hairer and Wanner, section IV.8), but not
// less than rounding: where that may be above the tolerance, iterations go on until they show it.
template <class Real>
typename RadauStep<Real>::Outcome RadauStep<Real>::judge(int iteration, double change, double ratio, double h,
                                                         const std::vector<double>& scales) {
    if (!std::isfinite(change)) return Outcome::failed;
    std::fill(noise_.begin(), noise_.end(), 0.0);
    const double enough = safety * tolerance_;
    if (change <= enough) return Outcome::converged;
    if (iteration == 0) return Outcome::go_on;
    bool is_exact = true, is_rounding = true;
    for (std::size_t a = 0; a < states_; ++a) {
        const double bound = rounding(a, h, scales);
        is_exact = is_exact && bound <= tolerance_ * scales[a];
        is_rounding = is_rounding && changes_[a] <= std::max(bound, enough * scales[a]);
    }
    if (is_exact && ratio < stalled && change * ratio / (1 - ratio) <= enough) return Outcome::converged;
    if (is_rounding && ratio >= stalled) {
        noise_ = changes_;
        return Outcome::converged;
    }
    return ratio > diverging && iteration > 1 ? Outcome::failed : Outcome::go_on;
}

// A bound for the rounding errors of the increments of a state.
template <class Real>
double RadauStep<Real>::rounding(std::size_t a, double h, const std::vector<double>& scales) const {
    double size = scales[a];
    for (std::size_t b = 0; b < states_; ++b) size += h * steepest_[a * states_ + b] * scales[b];
    return rounding_errors * RealTraits<Real>::roundoff() * size;
}

template class RadauStep<double>;
template class RadauStep<Float128>;
template class RadauStep<DoubleDouble>;

} // namespace resonform
