// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/conditions.hpp"

#include "model/files/interval_length.hpp"
#include "model/files/verify_reader.hpp"
#include "model/text/canonical.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

// Whether the interval is shorter than promised at this eps, by more than rounding.
bool is_shorter(const Scene& scene, const GiNaC::ex& promised, const Rational& eps) {
    constexpr double rounding = 1e-12;
    return length_at(scene, scene.verify.interval / promised, eps) < 1 - rounding;
}

} // namespace

Conditions conditions_of(const Scene& scene) {
    const VerifyPlan promised = read_verify(nullptr, scene); // defaults, as if the scene gave none
    Conditions conditions;
    conditions.interval = scene.verify.interval_text;
    conditions.promised = promised.interval_text;
    conditions.shorter_than_promised =
        std::any_of(scene.verify.eps.begin(), scene.verify.eps.end(),
                    [&](const Rational& eps) { return is_shorter(scene, promised.interval, eps); });
    for (const NamedFunction& f : scene.system->functions)
        if (f.data != nullptr) conditions.functions.emplace_back(f.name + "(" + f.of + ")", f.data_text);
    for (const NamedFunction& f : scene.system->functions)
        if (f.value) conditions.functions.emplace_back(f.name + "(" + f.of + ")", spell(f.value->value));
    for (const StartValue& value : scene.start) conditions.start.emplace_back(value.name, value.text);
    if (scene.at_zero) conditions.start.emplace_back("amplitude." + scene.at_zero->mode, "0");
    return conditions;
}

std::string shortness(const Conditions& conditions) {
    if (!conditions.shorter_than_promised) return "";
    return fmt::format("on t <= {} ONLY, shorter than {} as promised", conditions.interval,
                       conditions.promised);
}

} // namespace resonform
