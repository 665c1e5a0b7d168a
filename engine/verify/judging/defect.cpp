// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/defect.hpp"

#include "verify/estimate/times.hpp"
#include "verify/integrate/tape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace resonform {

namespace {

constexpr std::size_t points = 400;
constexpr double step_of_fastest = 1e-3;
// y' = sum_j c_j (y(t + j h) - y(t - j h))/h + O(h^8 y^(9)/630)
constexpr std::array<std::array<int, 2>, 4> coefficients{{{4, 5}, {-1, 5}, {4, 105}, {-1, 280}}};
// Of the scale and the rate: h^8/630, and what differences lose of 33 digits.
constexpr double known = 1e-26;

class Defect {
public:
    Defect(const Trial& trial, const TrialPoint& at, double rate)
        : program_(*trial.program()), system_(trial.system()), formula_(trial.evaluator<Float128>(at)),
          rates_(trial.tape(), at.parameters, at.eps_value), at_(at), rate_(rate),
          step_(step_of_fastest / rate) {}

    std::vector<EquationDefect> largest() {
        const double reach = static_cast<double>(coefficients.size()) * to_double_value(step_);
        const std::vector<double> times = even_times(at_.interval - reach, points, reach);
        std::vector<EquationDefect> result;
        for (const State& state : system_.states)
            if (state.derivative == 0) result.push_back({system_.system->variables[state.variable].name, {}});
        for (EquationDefect& equation : result) {
            equation.rung.eps = at_.eps;
            equation.rung.digits = 33;
            equation.rung.scale = 0;
        }
        for (const double t : times) add(Float128(t), result);
        for (EquationDefect& equation : result) {
            equation.rung.rms_error = std::sqrt(equation.rung.rms_error / static_cast<double>(points));
            equation.rung.floor = known * rate_ * equation.rung.scale;
        }
        return result;
    }

private:
    // All states of the system at t.
    [[nodiscard]] std::vector<Float128> state(const Float128& t) {
        std::vector<Float128> known_states(program_.state.size()), all(system_.states.size());
        if (const Status here = formula_.state(t, known_states.data()); !answers(here)) status_ = here;
        for (std::size_t k = 0; k < known_states.size(); ++k)
            all[static_cast<std::size_t>(&system_.state(program_.state[k].name) - system_.states.data())] =
                known_states[k];
        return all;
    }

    void add(const Float128& t, std::vector<EquationDefect>& result) {
        const std::vector<Float128> now = state(t);
        std::vector<Float128> slope(now.size()), rate(now.size());
        for (std::size_t j = 0; j < coefficients.size(); ++j) {
            const Float128 away = step_ * Float128(static_cast<int>(j) + 1);
            const std::vector<Float128> after = state(t + away), before = state(t - away);
            const Float128 c = Float128(coefficients[j][0]) / (Float128(coefficients[j][1]) * step_);
            for (std::size_t k = 0; k < now.size(); ++k) slope[k] += c * (after[k] - before[k]);
        }
        rates_.evaluate(now.data(), rate.data());
        std::vector<double> most(result.size());
        for (std::size_t k = 0; k < now.size(); ++k) {
            EquationDefect& equation = of(system_.states[k].variable, result);
            double& here = most[static_cast<std::size_t>(&equation - result.data())];
            here = std::fmax(here, std::abs(to_double_value(Float128(slope[k] - rate[k]))));
            equation.rung.scale = std::fmax(equation.rung.scale, std::abs(to_double_value(now[k])));
        }
        for (std::size_t e = 0; e < most.size(); ++e) {
            LadderRung& rung = result[e].rung;
            rung.max_error = answers(status_) ? std::fmax(rung.max_error, most[e]) : HUGE_VAL;
            rung.rms_error += most[e] * most[e];
            if (!answers(status_)) rung.refusal = told(status_, formula_.why(status_));
        }
    }

    static bool answers(Status status) { return status == Status::ok || status == Status::low_precision; }

    EquationDefect& of(std::size_t variable, std::vector<EquationDefect>& result) const {
        const std::string& name = system_.system->variables[variable].name;
        return *std::find_if(result.begin(), result.end(),
                             [&](const EquationDefect& e) { return e.variable == name; });
    }

    const Program& program_;
    const FirstOrderSystem& system_;
    Evaluator<Float128> formula_;
    BoundTape<Float128> rates_;
    const TrialPoint& at_;
    double rate_;
    Float128 step_;
    Status status_ = Status::ok;
};

} // namespace

std::string why_no_defect(const System& system) {
    for (const Variable& variable : system.variables)
        if (variable.role == Role::angle)
            return variable.name + ", an angle, is no output: the defect is not computed";
    return "";
}

std::vector<EquationDefect> defect_of(const Trial& trial, const TrialPoint& at, double rate) {
    return Defect(trial, at, rate).largest();
}

} // namespace resonform
