// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/start_scaling.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

// value(k eps) = k^weight value(eps) for k = 2 and 3.
bool scales(const GiNaC::ex& value, const GiNaC::symbol& eps, int weight) {
    for (const int k : {2, 3}) {
        const GiNaC::ex rest = value.subs(eps == k * eps) - pow(GiNaC::ex(k), weight) * value;
        if (!rest.normal().expand().is_zero()) return false;
    }
    return true;
}

} // namespace

int start_weight(const System& system, const std::string& name) {
    const Variable* variable = system.variable(name.substr(0, name.find('\'')));
    return variable != nullptr && variable->role == Role::fast ? variable->weight : 0;
}

std::string start_scaling_complaint(const Scene& scene) {
    for (const StartValue& start : scene.start) {
        const int weight = start_weight(*scene.system, start.name);
        if (scales(start.value, scene.system->eps, weight)) continue;
        return fmt::format(
            "{} starts at {}, which is not {}a constant: along a ladder of eps the error has no order",
            start.name, start.text,
            weight == 0   ? ""
            : weight == 1 ? "eps times "
                          : fmt::format("eps^{} times ", weight));
    }
    return "";
}

} // namespace resonform
