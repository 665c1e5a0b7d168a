// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/data_error.hpp"

#include "algebra/number/number.hpp"
#include "verify/estimate/times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace resonform {

namespace {

constexpr double tolerance = 1e-18; // of a step, in long double
constexpr std::size_t data_points = 2000;

// The equations with the spline through every other sample; nullopt: there is none.
std::optional<FirstOrderSystem> with_fewer_samples(FirstOrderSystem system) {
    System other = *system.system;
    bool any = false;
    for (NamedFunction& f : other.functions) {
        if (f.data == nullptr) continue;
        if (f.coarse_data == nullptr) return std::nullopt;
        f.data = f.coarse_data;
        any = true;
    }
    if (!any) return std::nullopt;
    system.system = std::make_shared<const System>(std::move(other));
    return system;
}

} // namespace

std::vector<DataError> data_errors(const Trial& trial, const Rational& eps) {
    const std::optional<FirstOrderSystem> fewer = with_fewer_samples(trial.system());
    if (!fewer) return {};
    const TrialPoint at = trial.point(eps);
    const auto narrowed = [](const std::vector<Float128>& all) {
        std::vector<long double> result;
        for (const Float128& x : all) result.push_back(convert<long double>(x));
        return result;
    };
    std::vector<long double> times;
    for (const double t : even_times(at.interval, data_points, 0)) times.push_back(t);
    const auto motion = [&](const Tape& tape) {
        return integrate_taylor<long double>(tape, narrowed(at.parameters),
                                             convert<long double>(at.eps_value), narrowed(at.start), times,
                                             tolerance);
    };
    const auto whole = motion(trial.tape()), other = motion(Tape::rates(*fewer));
    std::vector<DataError> errors;
    for (const std::size_t state : trial.output_states()) {
        DataError error{to_double(eps), 0};
        for (std::size_t i = 0; i < times.size(); ++i)
            error.error = std::max(
                error.error, std::abs(static_cast<double>(whole.values[state][i] - other.values[state][i])));
        if (!whole.failure.empty() || !other.failure.empty())
            error.error = std::numeric_limits<double>::quiet_NaN();
        errors.push_back(error);
    }
    return errors;
}

} // namespace resonform
