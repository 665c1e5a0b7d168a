// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/odeint.hpp"

#include <boost/numeric/odeint.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace resonform {

namespace {

namespace odeint = boost::numeric::odeint;
using Values = std::vector<double>;

constexpr std::size_t max_steps = 50'000'000;

struct RightHandSide {
    BoundTape<double>* rates;
    std::size_t* evaluations;
    void operator()(const Values& u, Values& rate, double) const {
        rates->evaluate(u.data(), rate.data());
        ++*evaluations;
    }
};

bool finite(const Values& u) {
    return std::all_of(u.begin(), u.end(), [](double x) { return std::isfinite(x); });
}

// odeint knows one absolute tolerance: the smallest that any state asks for.
double absolute_tolerance(const Values& start, double tolerance) {
    double scale = 1;
    for (double x : start)
        if (x != 0) scale = std::min(scale, std::abs(x));
    return tolerance * scale;
}

class Run {
public:
    Run(BoundTape<double>& rates, const Values& start, const Values& times, IntegrationResult& result)
        : right_{&rates, &result.evaluations}, start_(start), times_(times), result_(result) {
        while (next_ < times_.size() && times_[next_] <= 0) store(start_);
    }

    void dopri5(double absolute, double tolerance) {
        auto stepper = odeint::make_dense_output(absolute, tolerance, odeint::runge_kutta_dopri5<Values>());
        stepper.initialize(start_, 0.0, first_step());
        Values u(start_.size());
        while (next_ < times_.size()) {
            stepper.do_step(right_);
            if (!progressed(stepper.previous_time(), stepper.current_time(), stepper.current_state())) return;
            while (next_ < times_.size() && times_[next_] <= stepper.current_time()) {
                stepper.calc_state(times_[next_], u);
                store(u);
            }
        }
    }

    void fehlberg78(double absolute, double tolerance) {
        auto stepper = odeint::make_controlled(absolute, tolerance, odeint::runge_kutta_fehlberg78<Values>());
        Values u = start_;
        double t = 0, h = first_step();
        while (next_ < times_.size()) {
            const double before = t, left = times_[next_] - t, wanted = h;
            const bool shortened = h >= left;
            if (shortened) h = left;
            const bool accepted = stepper.try_step(right_, u, t, h) == odeint::success;
            if (accepted && shortened) {
                t = times_[next_];
                h = std::max(h, wanted);
                store(u);
            }
            if (!progressed(accepted ? before : t - h, t, u)) return; // t + h == t ends rejections too
        }
    }

private:
    [[nodiscard]] double first_step() const { return 1e-3 * std::min(1.0, times_.back()); }

    void store(const Values& u) {
        for (std::size_t i = 0; i < u.size(); ++i) result_.values[i][next_] = u[i];
        ++next_;
    }

    bool progressed(double before, double now, const Values& u) {
        if (!finite(u))
            result_.failure = fmt::format("a value is not finite near t = {:.6g}", now);
        else if (!(now > before))
            result_.failure = fmt::format("the step vanishes near t = {:.6g}", now);
        else if (++result_.steps > max_steps)
            result_.failure = fmt::format("more than {} steps", max_steps);
        return result_.failure.empty();
    }

    RightHandSide right_;
    const Values& start_;
    const Values& times_;
    IntegrationResult& result_;
    std::size_t next_ = 0;
};

} // namespace

IntegrationResult integrate_odeint(Method method, BoundTape<double> rates, const std::vector<double>& start,
                                   const std::vector<double>& times, double tolerance) {
    const auto begin = std::chrono::steady_clock::now();
    IntegrationResult result;
    result.values.assign(start.size(), std::vector<double>(times.size(), 0.0));
    try {
        Run run(rates, start, times, result);
        const double absolute = absolute_tolerance(start, tolerance);
        if (method == Method::dopri5)
            run.dopri5(absolute, tolerance);
        else
            run.fehlberg78(absolute, tolerance);
    } catch (const odeint::odeint_error& error) {
        result.failure = error.what();
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

} // namespace resonform
