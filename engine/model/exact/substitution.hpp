// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace resonform {

// e with every key of `values` replaced by its value, all at once; keys are symbols, not patterns.
inline GiNaC::ex put(const GiNaC::ex& e, const GiNaC::exmap& values) {
    return e.subs(values, GiNaC::subs_options::no_pattern);
}

// The same for values that hold keys themselves, until none is left. nullopt: they hold each other in a
// circle.
inline std::optional<GiNaC::ex> put_through(GiNaC::ex e, const GiNaC::exmap& values) {
    const auto holds_one = [&] {
        return std::any_of(values.begin(), values.end(), [&](const auto& v) { return e.has(v.first); });
    };
    for (std::size_t k = 0; k < values.size() && holds_one(); ++k) e = put(e, values);
    return holds_one() ? std::nullopt : std::optional<GiNaC::ex>(e);
}

struct TimeDerivative {
    GiNaC::symbol of;
    GiNaC::ex value;
};

// d/dt of e by the chain rule; symbols without a derivative in the list are constant.
inline GiNaC::ex along(const GiNaC::ex& e, const std::vector<TimeDerivative>& motion) {
    GiNaC::ex sum = 0;
    for (const TimeDerivative& derivative : motion) sum += e.diff(derivative.of) * derivative.value;
    return sum;
}

} // namespace resonform
