// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/odeint.hpp"

#include "verify/integrate/step_budget.hpp"

#include <boost/numeric/odeint.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace resonform {

namespace {

namespace odeint = boost::numeric::odeint;
using Values = std::vector<double>;
using DenseDopri5 = odeint::result_of::make_dense_output<odeint::runge_kutta_dopri5<Values>>::type;
using BulirschStoer = odeint::bulirsch_stoer_dense_out<Values>;
using Fehlberg78 = odeint::result_of::make_controlled<odeint::runge_kutta_fehlberg78<Values>>::type;

struct Rates {
    RightHandSide f;
    std::size_t* evaluations;
    void operator()(const Values& u, Values& rate, double) const {
        f.call(f.context, u.data(), rate.data());
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

// Methods keep their steppers from run to run.
class Odeint : public Integrator {
public:
    Odeint(Method method, RightHandSide rates, const Start& start)
        : method_(method), rates_(rates), start_(start), u_(start.state.size()) {
        const double absolute = absolute_tolerance(start.state, start.tolerance);
        if (method == Method::dopri5)
            dopri5_ =
                odeint::make_dense_output(absolute, start.tolerance, odeint::runge_kutta_dopri5<Values>());
        else if (method == Method::bulirsch_stoer)
            bulirsch_stoer_.emplace(absolute, start.tolerance);
        else
            fehlberg78_ =
                odeint::make_controlled(absolute, start.tolerance, odeint::runge_kutta_fehlberg78<Values>());
    }

    resonform::Run run(const std::vector<double>& times, std::vector<Values>& values) override {
        OneRun run{*this, times, values, {}, 0};
        try {
            while (run.next < times.size() && times[run.next] <= 0) run.store(start_.state);
            if (method_ == Method::dopri5)
                run.dense(*dopri5_);
            else if (method_ == Method::bulirsch_stoer)
                run.dense(*bulirsch_stoer_);
            else
                run.fehlberg78();
        } catch (const odeint::odeint_error& error) {
            run.result.failure = error.what();
        }
        return run.result;
    }

private:
    struct OneRun {
        Odeint& own;
        const Values& times;
        std::vector<Values>& values;
        resonform::Run result;
        std::size_t next;

        // Steps as they come, with the method's own interpolation.
        template <class Stepper> void dense(Stepper& stepper) {
            const Rates rates{own.rates_, &result.evaluations};
            stepper.initialize(own.start_.state, 0.0, first_step());
            while (next < times.size()) {
                stepper.do_step(rates);
                if (!progressed(stepper.previous_time(), stepper.current_time(), stepper.current_state()))
                    return;
                while (next < times.size() && times[next] <= stepper.current_time()) {
                    stepper.calc_state(times[next], own.u_);
                    store(own.u_);
                }
            }
        }

        void fehlberg78() {
            auto& stepper = *own.fehlberg78_;
            const Rates rates{own.rates_, &result.evaluations};
            Values& u = own.u_;
            u = own.start_.state;
            double t = 0, h = first_step();
            while (next < times.size()) {
                const double before = t, left = times[next] - t, wanted = h;
                const bool shortened = h >= left;
                if (shortened) h = left;
                const bool accepted = stepper.try_step(rates, u, t, h) == odeint::success;
                if (accepted && shortened) {
                    t = times[next];
                    h = std::max(h, wanted);
                    store(u);
                }
                if (!progressed(accepted ? before : t - h, t, u)) return; // t + h == t ends rejections too
            }
        }

        [[nodiscard]] double first_step() const { return 1e-3 * std::min(1.0, times.back()); }

        void store(const Values& u) {
            for (std::size_t k = 0; k < own.start_.wanted.size(); ++k)
                values[k][next] = u[own.start_.wanted[k]];
            ++next;
        }

        bool progressed(double before, double now, const Values& u) {
            if (!finite(u))
                result.failure = fmt::format("a value is not finite near t = {:.6g}", now);
            else if (!(now > before))
                result.failure = fmt::format("the step vanishes near t = {:.6g}", now);
            else if (rival_budget.is_spent(++result.steps, now, times.back()))
                result.failure = fmt::format("more than {} steps", rival_budget.most);
            return result.failure.empty();
        }
    };

    Method method_;
    RightHandSide rates_;
    Start start_;
    std::optional<DenseDopri5> dopri5_;
    std::optional<BulirschStoer> bulirsch_stoer_;
    std::optional<Fehlberg78> fehlberg78_;
    Values u_;
};

} // namespace

std::unique_ptr<Integrator> make_odeint(Method method, RightHandSide rates, const Start& start) {
    return std::make_unique<Odeint>(method, rates, start);
}

} // namespace resonform
