// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/system/scene_file.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/real_ball.hpp"
#include "model/system/start_names.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/named_function.hpp"
#include "model/text/regular.hpp"
#include "model/text/why_unreal.hpp"
#include "model/text/zero_test.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

// What the symbol `eps` is at eps = 0.1, as a number: of a root not more than some digits matter.
GiNaC::numeric estimated_eps(const System& system) {
    if (system.eps_root == 1) return {1, 10};
    return {std::lround(1e6 * std::pow(0.1, 1.0 / system.eps_root)), 1'000'000L};
}

constexpr int double_exponent = 1000; // of two: beyond this a double may overflow

bool holds_large_number(const GiNaC::ex& e) {
    return std::any_of(e.preorder_begin(), e.preorder_end(), [](const GiNaC::ex& part) {
        if (!GiNaC::is_a<GiNaC::numeric>(part)) return false;
        const auto& n = GiNaC::ex_to<GiNaC::numeric>(part);
        return n.numer().int_length() > double_exponent || n.denom().int_length() > double_exponent;
    });
}

} // namespace

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
    GiNaC::exmap cancelled;
    for (const Parameter& p : system->cancelled)
        if (const auto found = fix.find(p.name); found != fix.end()) {
            scope.define(p.name, found->second);
            cancelled.emplace(p.symbol, found->second);
        }
    for (const Setting& set : system->settings)
        if (const auto found = fix.find(set.parameter); found != fix.end())
            scope.define(set.parameter, found->second);
    for (const NamedFunction& f : system->functions) {
        if (f.data != nullptr) scope.define_data(f.name, f.of, f.data);
        if (f.callable) scope.define_function(f.name);
        if (!f.value) continue;
        const GiNaC::ex value = f.value->value.subs(cancelled, GiNaC::subs_options::no_pattern);
        const bool known = std::none_of(system->cancelled.begin(), system->cancelled.end(),
                                        [&](const Parameter& p) { return value.has(p.symbol); });
        if (known) scope.define_function(f.name, FunctionValue{f.value->argument, value});
    }
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
    const auto regular = where_regular([&] { return fixed(value); });
    if (!regular) return Estimate::unbounded;
    const GiNaC::ex& e = *regular;
    if (vanishes(e) == Zero::yes) return Estimate::zero; // (sqrt(2) + 1)*(sqrt(2) - 1) - 1
    if (has_named(e)) return Estimate::unknown;
    for (const Parameter& p : system->parameters) {
        if (e.has(p.symbol)) return Estimate::unknown;
    }
    const std::optional<RealBall> here = enclose(e, {{system->eps, estimated_eps(*system)}});
    if (!here || binary_exponent(*here) > double_exponent || holds_large_number(e))
        return Estimate::unbounded;
    const int sign = here->sign();
    return sign > 0 ? Estimate::positive : sign < 0 ? Estimate::negative : Estimate::unknown;
}

std::string Scene::why_unreal(const GiNaC::ex& value) const {
    GiNaC::exmap point{{system->eps, estimated_eps(*system)}};
    for (const Parameter& p : system->parameters)
        if (const auto found = fix.find(p.name); found != fix.end()) point[p.symbol] = found->second;
    const std::string why = resonform::why_unreal(value, point);
    return why.empty() ? "" : why + " at eps = 0.1";
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
