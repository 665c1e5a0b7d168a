// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/start_scaling.hpp"

#include "algebra/number/number.hpp"
#include "model/text/eps_powers.hpp"

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

// A start value as the expansion has it: measured from the equilibrium, at the start values of slow
// variables.
GiNaC::ex measured(const Scene& scene, const StartValue& start) {
    if (!rests_elsewhere(*scene.system, start.name)) return start.value;
    GiNaC::exmap slow;
    for (const Variable& v : scene.system->variables)
        if (const StartValue* value = scene.start_of(v.name); v.role == Role::slow && value != nullptr)
            slow[v.jet.front()] = value->value;
    return scene.fixed(start.value - rest_of(*scene.system, start.name, slow));
}

} // namespace

bool rests_elsewhere(const System& system, const std::string& name) {
    const Variable* variable = system.variable(name);
    return variable != nullptr &&
           system.equilibrium_of(static_cast<std::size_t>(variable - system.variables.data())) != nullptr;
}

GiNaC::ex rest_of(const System& system, const std::string& name, const GiNaC::exmap& slow) {
    const auto variable = static_cast<std::size_t>(system.variable(name) - system.variables.data());
    return system.equilibrium_of(variable)->value.subs(slow, GiNaC::subs_options::no_pattern);
}

int start_weight(const System& system, const std::string& name) {
    const Variable* variable = system.variable(name.substr(0, name.find('\'')));
    return variable != nullptr && variable->role == Role::fast ? variable->weight : 0;
}

std::string start_scaling_complaint(const Scene& scene) {
    for (const StartValue& start : scene.start) {
        const int weight = start_weight(*scene.system, start.name);
        const GiNaC::ex value = measured(scene, start);
        if (scales(value, scene.system->eps, weight)) continue;
        const Rational power = scene.system->weight(weight);
        return fmt::format(
            "{} starts at {}, which is not {}{}a constant: along a ladder of eps the error has no order",
            start.name, start.text, rests_elsewhere(*scene.system, start.name) ? "its equilibrium plus " : "",
            weight == 0  ? ""
            : power == 1 ? "eps times "
                         : spell_eps_power(power) + " times ");
    }
    return "";
}

} // namespace resonform
