// SPDX-License-Identifier: GPL-3.0-or-later
// The implicit integrator: step lengths, guesses, dense output.
#include "verify/integrate/integrate.hpp"
#include "verify/integrate/radau.hpp"
#include "verify/integrate/radau_step.hpp"
#include "verify/integrate/step_budget.hpp"
#include "verify/run/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace resonform {

namespace {

// A layer at the start takes about a hundred steps, one that oscillates while it decays takes thousands; they
// say little about the rest.
constexpr std::size_t pilot_implicit_steps = 3000;
constexpr double longest_growth = 4, shortest_growth = 0.2, caution = 0.9;
// A polynomial of high degree is no guess far beyond its step.
constexpr double farthest_guess = 1.25;
constexpr double after_failure = 0.25; // of the step whose equations were not solved
// The last coefficients of a polynomial are made of rounding errors below this: no step would do.
constexpr double least_tolerance = 1000; // in units of the last place

// The work per unit of time, s^3 over the length of a step, is least near these for a motion like a sine.
int best_stages(double tolerance) {
    return std::clamp(static_cast<int>(std::ceil(4 - 0.34 * std::log(tolerance))), 5, 30);
}

// The collocation polynomial of the last step: increments theta sum_k q_k P_k(2 theta - 1).
template <class Real> class StepPolynomial {
public:
    StepPolynomial(const RadauRule<Real>& rule, std::size_t states)
        : rule_(&rule), states_(states), q_(rule.stages * states, Real(0)) {}

    void through(const std::vector<Real>& increments) {
        for (std::size_t k = 0; k < rule_->stages; ++k)
            for (std::size_t a = 0; a < states_; ++a) {
                Real sum(0);
                for (std::size_t j = 0; j < rule_->stages; ++j)
                    sum += rule_->spectrum[k * rule_->stages + j] * increments[j * states_ + a];
                q_[k * states_ + a] = sum;
            }
    }

    // What the last two terms of a state add at most.
    [[nodiscard]] double tail(std::size_t a) const {
        const auto size = [&](std::size_t k) { return std::abs(to_double_value(q_[k * states_ + a])); };
        return std::max(size(rule_->stages - 1), size(rule_->stages - 2));
    }

    // Increments of all states from the start of the step.
    [[nodiscard]] std::vector<Real> at(const Real& theta) const {
        const std::vector<Real> p = legendre(Real(Real(2) * theta - Real(1)), rule_->stages);
        std::vector<Real> sums(states_, Real(0));
        for (std::size_t k = 0; k < rule_->stages; ++k)
            for (std::size_t a = 0; a < states_; ++a) sums[a] += q_[k * states_ + a] * p[k];
        for (Real& sum : sums) sum *= theta;
        return sums;
    }

private:
    const RadauRule<Real>* rule_;
    std::size_t states_;
    std::vector<Real> q_; // [k * states + state]
};

template <class Real> class ImplicitRun {
public:
    ImplicitRun(const Tape& tape, const std::vector<Real>& parameters, const Real& eps,
                std::vector<Real> start, double tolerance)
        : rule_(best_stages(tolerance)), step_(tape, parameters, eps, rule_, tolerance),
          polynomial_(rule_, start.size()), state_(std::move(start)), scales_(state_.size()),
          tolerance_(tolerance) {
        for (std::size_t a = 0; a < state_.size(); ++a) scales_[a] = std::abs(to_double_value(state_[a]));
    }

    void run(const std::vector<Real>& times, std::size_t most_steps, Integration<Real>& result);
    [[nodiscard]] std::size_t evaluations() const { return step_.evaluations(); }

private:
    // 1/|f'|, the length of the fastest layer. False: f has no value.
    bool choose_first_step();
    bool try_step(double h);
    [[nodiscard]] std::vector<Real> guess(double h) const;

    RadauRule<Real> rule_;
    RadauStep<Real> step_;
    StepPolynomial<Real> polynomial_; // of the last step, which began at from_ and was last_ long
    Real t_ = Real(0), from_ = Real(0), last_ = Real(0);
    double next_ = 0; // the length to try
    std::vector<Real> state_, before_;
    std::vector<double> scales_;
    double tolerance_;
};

template <class Real> bool ImplicitRun<Real>::choose_first_step() {
    std::vector<Real> rates(state_.size(), Real(0));
    if (!step_.rates(state_, rates)) return false;
    double norm = 0;
    const std::vector<double>& slopes = step_.jacobian(state_);
    for (std::size_t a = 0; a < state_.size(); ++a) {
        double sum = 0;
        for (std::size_t b = 0; b < state_.size(); ++b) sum += std::abs(slopes[a * state_.size() + b]);
        norm = std::max(norm, sum);
    }
    next_ = norm > 0 && std::isfinite(norm) ? 1 / norm : 1;
    return true;
}

// The last polynomial goes on for a while; before there is one, and after a jump in length, nothing moves.
template <class Real> std::vector<Real> ImplicitRun<Real>::guess(double h) const {
    std::vector<Real> increments(rule_.stages * state_.size(), Real(0));
    const double before = to_double_value(last_);
    if (!(h <= farthest_guess * before)) return increments;
    const std::vector<Real> end = polynomial_.at(Real(1));
    for (std::size_t j = 0; j < rule_.stages; ++j) {
        const std::vector<Real> there = polynomial_.at(Real(Real(1) + rule_.nodes[j] * Real(h / before)));
        for (std::size_t a = 0; a < state_.size(); ++a) increments[j * state_.size() + a] = there[a] - end[a];
    }
    return increments;
}

// Takes the step if the equations are solved and the last terms of the polynomial are below the tolerance;
// chooses the next length.
template <class Real> bool ImplicitRun<Real>::try_step(double h) {
    const Real end = t_ + Real(h), length = end - t_; // the difference is exact, or the clock would drift
    std::vector<Real> increments = guess(h);
    std::vector<double> scales = scales_;
    if (!step_.solve(state_, length, increments, scales)) {
        next_ = after_failure * h;
        return false;
    }
    StepPolynomial<Real> polynomial(rule_, state_.size());
    polynomial.through(increments);
    double error = 0; // in tolerances
    for (std::size_t a = 0; a < state_.size(); ++a) {
        // A rounding error of an increment shows in a coefficient with a factor of at most about 2s.
        const double noise = 2 * static_cast<double>(rule_.stages) * step_.noise()[a];
        const double allowed = std::max(tolerance_ * scales[a], noise);
        if (polynomial.tail(a) > 0) error = std::max(error, polynomial.tail(a) / allowed);
    }
    const double growth = caution * std::pow(error, -1 / static_cast<double>(rule_.stages));
    next_ = h * std::clamp(growth, shortest_growth, longest_growth);
    if (!(error <= 1)) return false;
    polynomial_ = std::move(polynomial);
    scales_ = std::move(scales);
    before_ = state_;
    for (std::size_t a = 0; a < state_.size(); ++a)
        state_[a] += increments[(rule_.stages - 1) * state_.size() + a];
    from_ = t_;
    last_ = length;
    t_ = end;
    return true;
}

template <class Real>
void ImplicitRun<Real>::run(const std::vector<Real>& times, std::size_t most_steps,
                            Integration<Real>& result) {
    const StepBudget budget{most_steps, pilot_implicit_steps};
    std::size_t next = 0;
    const auto store = [&](const std::vector<Real>& from, const std::vector<Real>& increments) {
        for (std::size_t a = 0; a < from.size(); ++a) result.values[a][next] = from[a] + increments[a];
        ++next;
    };
    while (next < times.size() && times[next] <= t_) store(state_, std::vector<Real>(state_.size(), Real(0)));
    if (!choose_first_step()) {
        result.failure = "the solution leaves the domain of the equations near t = 0";
        return;
    }
    while (next < times.size()) {
        const double end = to_double_value(times.back()), t = to_double_value(t_);
        const double h = std::min(next_, to_double_value(Real(times.back() - t_)) * (1 + 0x1p-20));
        if (!(t_ + Real(h) > t_)) {
            result.failure = fmt::format("the steps shrink to {:.1e} near t = {:.6g}", h, t);
            return;
        }
        if (try_step(h))
            while (next < times.size() && times[next] <= t_)
                store(before_, polynomial_.at(Real((times[next] - from_) / last_)));
        if (budget.is_spent(++result.steps, to_double_value(t_), end) && next < times.size()) {
            result.too_far = true;
            result.failure = fmt::format(
                "it takes more than {} implicit steps: the first {} lead to t = {:.3g} of {:.3g} only",
                most_steps, result.steps, to_double_value(t_), end);
            return;
        }
    }
}

} // namespace

template <class Real>
Integration<Real> integrate_implicit(const Tape& tape, const std::vector<Real>& parameters, const Real& eps,
                                     const std::vector<Real>& start, const std::vector<Real>& times,
                                     double tolerance, std::size_t most_steps) {
    const auto begin = std::chrono::steady_clock::now();
    tolerance = std::max(tolerance, least_tolerance * RealTraits<Real>::roundoff());
    Integration<Real> result;
    result.values.assign(start.size(), std::vector<Real>(times.size(), Real(0)));
    ImplicitRun<Real> run(tape, parameters, eps, start, tolerance);
    run.run(times, most_steps, result);
    result.evaluations = run.evaluations();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

#define RESONFORM_INSTANTIATE(Real)                                                                          \
    template Integration<Real> integrate_implicit(const Tape&, const std::vector<Real>&, const Real&,        \
                                                  const std::vector<Real>&, const std::vector<Real>&,        \
                                                  double, std::size_t);
RESONFORM_INSTANTIATE(double)
RESONFORM_INSTANTIATE(Float128)
RESONFORM_INSTANTIATE(DoubleDouble)
#undef RESONFORM_INSTANTIATE

} // namespace resonform
