// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/answers.hpp"

#include "runtime/status.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

bool is_beyond_double(const SymbolicPoint& exact) {
    return std::any_of(exact.scales.begin(), exact.scales.end(),
                       [](const Wide& scale) { return !(scale < Wide(std::numeric_limits<double>::max())); });
}

} // namespace

std::vector<StabilityAnswer> StabilityTrial::operator()(const SweepPoint& at, std::size_t times) const {
    const Evaluator<double> emitted(library_, at.eps, at.parameters, at.start, end());
    StabilityReference::From exact(reference_, at, end());
    std::vector<double> values(program_.outputs.size());
    std::vector<StabilityAnswer> answers(times);
    for (std::size_t i = 0; i < times; ++i) {
        StabilityAnswer& answer = answers[i];
        answer.t = shares_of_interval[i] * program_.interval_slow_time / at.eps;
        answer.status = emitted.call(answer.t, values.data());
        answer.why = emitted.why(answer.status);
        judge(answer, values, exact);
    }
    return answers;
}

// Every input lies within its declared range: none of them can be a bad argument.
bool StabilityTrial::explains(const StabilityAnswer& answer, const SymbolicPoint& exact,
                              StabilityReference::From& from) const {
    if (answer.status == Status::bad_argument) return false;
    if (exact.status != Status::ok || is_beyond_double(exact)) return true;
    if (answer.status == Status::outside_interval && from.loses_phase(answer.t)) return true;
    if (answer.status == Status::low_precision &&
        (from.has_large_phase(answer.t) || (!exponent_.empty() && answer.why == exponent_)))
        return true;
    return std::isinf(from.conditioning(answer.t).sum.front());
}

void StabilityTrial::judge(StabilityAnswer& answer, const std::vector<double>& values,
                           StabilityReference::From& from) const {
    const SymbolicPoint& exact = from.at(answer.t);
    answer.known = exact.status != Status::outside_interval;
    if (!answer.known) return;
    if (answer.status != Status::ok) {
        answer.explained = explains(answer, exact, from);
        return;
    }
    answer.ulp = from.ulp(answer.t, values);
    answer.units = from.units();
    answer.conditioning = Conditioning(values.size(), 0);
    if (std::any_of(answer.ulp.begin(), answer.ulp.end(), [&](double u) { return !(u <= threshold_); }))
        answer.conditioning = from.conditioning(answer.t);
}

} // namespace resonform
