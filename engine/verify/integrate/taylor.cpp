// SPDX-License-Identifier: GPL-3.0-or-later
// The Taylor-series integrator: steps, step lengths, dense output.
#include "verify/integrate/breakpoints.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/integrate/step_budget.hpp"
#include "verify/integrate/taylor_jet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace resonform {

namespace {

constexpr std::size_t pilot_taylor_steps = 10'000;

int best_order(double tolerance) {
    return std::clamp(static_cast<int>(std::ceil(1 - 0.5 * std::log(tolerance))), 6, 60);
}

// One run: the jet at the present time, and the scales against which its tail is measured.
template <class Real> class Stepper {
public:
    Stepper(const BoundTape<Real>& tape, std::vector<Real> start, double tolerance, int order)
        : jet_(tape, order), data_(tape.tape().data()), state_(std::move(start)), scale_(state_.size(), 0.0),
          tolerance_(tolerance) {}

    // Expands about the present state. False if a coefficient is not finite.
    bool expand() {
        jet_.expand(state_);
        for (std::size_t i = 0; i < state_.size(); ++i)
            for (int k : {0, jet_.order() - 1, jet_.order()})
                if (!std::isfinite(size(i, k))) return false;
        return true;
    }

    // The longest step with |c_k| h^k <= tolerance*scale for the last two k, in every state.
    double step() {
        update_scales();
        double h = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < state_.size(); ++i)
            for (int k : {jet_.order() - 1, jet_.order()})
                if (size(i, k) > 0) h = std::min(h, std::pow(tolerance_ * scale_[i] / size(i, k), 1.0 / k));
        for (const Tape::Data& data : data_)
            h = within_piece(*data.samples, jet_.coefficients(data.state), jet_.order(), h);
        return h;
    }

    void advance(const Real& h) {
        for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = jet_.value(static_cast<int>(i), h);
    }
    [[nodiscard]] Real value(std::size_t state, const Real& h) const {
        return jet_.value(static_cast<int>(state), h);
    }

private:
    [[nodiscard]] double size(std::size_t state, int k) const {
        return std::abs(to_double_value(jet_.coefficients(static_cast<int>(state))[k]));
    }

    // A state may start at zero: then its first coefficients, over the time scale on which the
    // solution changes, say how large it is about to be.
    void update_scales() {
        double time_scale = std::numeric_limits<double>::infinity();
        const int n = jet_.order();
        for (std::size_t i = 0; i < state_.size(); ++i) {
            const double low = std::max({size(i, 0), size(i, 1), size(i, 2)});
            if (low > 0 && size(i, n) > 0)
                time_scale = std::min(time_scale, std::pow(low / size(i, n), 1.0 / n));
        }
        if (!std::isfinite(time_scale)) time_scale = 1;
        for (std::size_t i = 0; i < state_.size(); ++i) {
            scale_[i] = std::max(
                {scale_[i], size(i, 0), size(i, 1) * time_scale, size(i, 2) * time_scale * time_scale});
            for (int k = 3; k < n && scale_[i] == 0; ++k) scale_[i] = size(i, k) * std::pow(time_scale, k);
        }
    }

    TaylorJet<Real> jet_;
    std::vector<Tape::Data> data_;
    std::vector<Real> state_;
    std::vector<double> scale_;
    double tolerance_;
};

template <class Real>
void take_steps(Stepper<Real>& stepper, const std::vector<Real>& times, std::size_t most_steps,
                Integration<Real>& result) {
    const StepBudget budget{most_steps, pilot_taylor_steps};
    Real t(0);
    std::size_t next = 0;
    while (next < times.size()) {
        if (!stepper.expand()) {
            result.failure = fmt::format("the solution leaves the domain of the equations near t = {:.6g}",
                                         to_double_value(t));
            return;
        }
        // Steps end at numbers whose difference is exact, or the clock itself would drift.
        const double h = std::min(stepper.step(), 2 * to_double_value(Real(times.back() - t)) + 1);
        const Real end = t + Real(h);
        if (!(end > t)) {
            result.failure = fmt::format("the steps shrink to {:.1e} near t = {:.6g}", h, to_double_value(t));
            return;
        }
        if (budget.is_spent(++result.steps, to_double_value(end), to_double_value(times.back()))) {
            result.too_far = true;
            result.failure =
                fmt::format("it takes more than {} steps: the first {} lead to t = {:.3g} of {:.3g} only",
                            most_steps, result.steps, to_double_value(end), to_double_value(times.back()));
            return;
        }
        for (; next < times.size() && times[next] <= end; ++next)
            for (std::size_t i = 0; i < result.values.size(); ++i)
                result.values[i][next] = stepper.value(i, times[next] - t);
        stepper.advance(end - t);
        t = end;
    }
}

} // namespace

template <class Real>
Integration<Real> integrate_taylor(const Tape& tape, const std::vector<Real>& parameters, const Real& eps,
                                   const std::vector<Real>& start, const std::vector<Real>& times,
                                   double tolerance, int order, std::size_t most_steps) {
    const auto begin = std::chrono::steady_clock::now();
    Integration<Real> result;
    result.values.assign(start.size(), std::vector<Real>(times.size(), Real(0)));
    const BoundTape<Real> bound(tape, parameters, eps);
    Stepper<Real> stepper(bound, start, tolerance, order > 0 ? std::max(order, 2) : best_order(tolerance));
    take_steps(stepper, times, most_steps, result);
    result.evaluations = result.steps;
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

#define RESONFORM_INSTANTIATE(Real)                                                                          \
    template Integration<Real> integrate_taylor(const Tape&, const std::vector<Real>&, const Real&,          \
                                                const std::vector<Real>&, const std::vector<Real>&, double,  \
                                                int, std::size_t);
RESONFORM_INSTANTIATE(double)
RESONFORM_INSTANTIATE(long double)
RESONFORM_INSTANTIATE(Float128)
RESONFORM_INSTANTIATE(DoubleDouble)
#undef RESONFORM_INSTANTIATE

} // namespace resonform
