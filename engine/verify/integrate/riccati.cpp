// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/riccati.hpp"

#include "verify/integrate/oscillator_step.hpp"
#include "verify/integrate/step_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

constexpr double one_wave = 6.3;        // radians: shorter steps are left to collocation
constexpr double first_collocation = 4; // radians

class Riccati : public Integrator {
public:
    Riccati(RightHandSide rates, LinearOscillator oscillator, const resonform::Start& start)
        : coefficients_(rates, oscillator, start.state), oscillator_(oscillator), start_(start) {}

    Run run(const std::vector<double>& times, std::vector<std::vector<double>>& values) override {
        Run run;
        now_ = {0, start_.state[oscillator_.u], start_.state[oscillator_.v], start_.tolerance};
        iterated_ = times.back();
        collocated_ = 0;
        std::size_t next = 0;
        for (; next < times.size() && times[next] <= 0; ++next)
            for (std::size_t k = 0; k < start_.wanted.size(); ++k)
                values[k][next] = start_.state[start_.wanted[k]];
        while (next < times.size()) {
            const double rest = times.back() - now_.t, length = advance(rest);
            const double end = length == rest ? times.back() : now_.t + length;
            if (!(end > now_.t)) {
                run.failure = fmt::format("the steps end near t = {:.6g}", now_.t);
                break;
            }
            if (rival_budget.is_spent(++run.steps, end, times.back())) {
                run.failure = fmt::format("more than {} steps", rival_budget.most);
                break;
            }
            for (; next < times.size() && times[next] <= end; ++next) keep(times[next], next, values);
            now_ = {end, step_.u(end), step_.v(end), start_.tolerance};
        }
        run.evaluations = run.steps;
        return run;
    }

private:
    // Makes a step of at most `rest`: its length, 0 if there is none.
    double advance(double rest) {
        const double fastest = std::sqrt(std::max(0.0, coefficients_.at(now_.t).square));
        for (double h = std::min(rest, 2 * iterated_); h * fastest > one_wave; h /= 2)
            if (step_.by_iterations(coefficients_, now_, h)) {
                iterated_ = h;
                return h;
            }
        const double guess = collocated_ > 0 ? 2 * collocated_
                             : fastest > 0   ? first_collocation / fastest
                                             : rest;
        for (double h = std::min(rest, guess); now_.t + h > now_.t; h /= 2)
            if (step_.by_collocation(coefficients_, now_, h)) {
                collocated_ = h;
                iterated_ = std::max(iterated_ / 2, 4 * h);
                return h;
            }
        return 0;
    }
    void keep(double t, std::size_t i, std::vector<std::vector<double>>& values) const {
        for (std::size_t k = 0; k < start_.wanted.size(); ++k) {
            const std::size_t state = start_.wanted[k];
            values[k][i] = state == oscillator_.u   ? step_.u(t)
                           : state == oscillator_.v ? step_.v(t)
                                                    : coefficients_.slow(state, t);
        }
    }

    OscillatorCoefficients coefficients_;
    LinearOscillator oscillator_;
    resonform::Start start_;
    oscillator::Step step_;
    oscillator::Step::Start now_{};
    double iterated_ = 0, collocated_ = 0; // the last lengths
};

} // namespace

std::unique_ptr<Integrator> make_riccati(RightHandSide rates, LinearOscillator oscillator,
                                         const Start& start) {
    return std::make_unique<Riccati>(rates, oscillator, start);
}

} // namespace resonform
