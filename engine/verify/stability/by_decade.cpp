// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/by_decade.hpp"

#include "runtime/status.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

constexpr double rounded_power = 1e-9; // of log10: 10^3 may have become 999.9999999

std::optional<int> exponent_of(double value) {
    if (value == 0) return std::nullopt;
    return static_cast<int>(std::floor(std::log10(std::abs(value)) + rounded_power));
}

Decade& decade_of(double value, std::vector<Decade>& decades) {
    const std::optional<int> exponent = exponent_of(value);
    const auto found = std::lower_bound(decades.begin(), decades.end(), exponent,
                                        [](const Decade& d, const auto& e) { return d.exponent < e; });
    if (found != decades.end() && found->exponent == exponent) return *found;
    return *decades.insert(found, Decade{exponent});
}

} // namespace

double Decade::from() const { return exponent ? std::pow(10, *exponent) : 0; }

std::vector<InputByDecade> no_decades(const std::vector<SweptInput>& inputs) {
    std::vector<InputByDecade> all;
    for (const SweptInput& input : inputs) all.push_back({input});
    all.push_back({{"t", 0, 0, false, true}});
    return all;
}

void add(const SweepPoint& at, const StabilityAnswer& answer, std::vector<InputByDecade>& all) {
    std::vector<SweptInput> inputs;
    for (const InputByDecade& own : all) inputs.push_back(own.input);
    std::vector<double> values = as_swept(at, inputs);
    values.push_back(answer.t);
    for (std::size_t i = 0; i < all.size(); ++i) {
        Decade& decade = decade_of(values[i], all[i].decades);
        if (answer.status != Status::ok) {
            ++decade.refused_by[to_string(answer.status)];
            continue;
        }
        ++decade.compared;
        decade.ulp.resize(answer.ulp.size(), 0.0);
        for (std::size_t k = 0; k < answer.ulp.size(); ++k)
            decade.ulp[k] = std::max(decade.ulp[k], answer.ulp[k]);
    }
}

} // namespace resonform
