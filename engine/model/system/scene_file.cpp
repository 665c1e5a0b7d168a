// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/system/scene_file.hpp"

#include "model/system/start_names.hpp"
#include "model/text/zero_test.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

const char* to_string(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::undecided: break;
    }
    return "undecided";
}

bool Scene::wants(const std::string& output) const {
    return std::find(outputs.begin(), outputs.end(), output) != outputs.end();
}

const StartValue* Scene::start_of(const std::string& canonical) const {
    for (const StartValue& value : start) {
        if (canonical_start(value.name, *system) == canonical) return &value;
    }
    return nullptr;
}

Scope Scene::constants() const {
    Scope scope = system->constants();
    for (const Parameter& p : system->cancelled)
        if (const auto found = fix.find(p.name); found != fix.end()) scope.define(p.name, found->second);
    return scope;
}

GiNaC::ex Scene::fixed(const GiNaC::ex& value) const {
    GiNaC::exmap values;
    for (const Parameter& p : system->parameters) {
        const auto found = fix.find(p.name);
        if (found != fix.end()) values[p.symbol] = found->second;
    }
    return value.subs(values);
}

Estimate Scene::estimate(const GiNaC::ex& value) const {
    GiNaC::ex e;
    try {
        e = fixed(value);
    } catch (const std::exception&) { // a denominator became zero
        return Estimate::unbounded;
    }
    if (vanishes(e) == Zero::yes) return Estimate::zero; // (sqrt(2) + 1)*(sqrt(2) - 1) - 1
    for (const Parameter& p : system->parameters) {
        if (e.has(p.symbol)) return Estimate::unknown;
    }
    const Ball ball = evaluate(e, {{system->eps, GiNaC::numeric(1, 10)}});
    if (ball.excludes_zero()) return ball.middle > 0 ? Estimate::positive : Estimate::negative;
    return std::isfinite(ball.radius) ? Estimate::unknown : Estimate::unbounded;
}

void not_fixed(const Scene& scene, const std::string& rule, const std::vector<std::string>& missing) {
    std::string names, values;
    for (const std::string& name : missing) {
        names += (names.empty() ? "" : ", ") + name;
        values += (values.empty() ? "" : " and ") + name + " = ...";
    }
    bad_input({rule, "no value of " + names, "add " + values + " under [fix]", scene.fix_place});
}

} // namespace resonform
