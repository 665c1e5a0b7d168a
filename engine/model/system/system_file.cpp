// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/system/system_file.hpp"

#include "model/text/named_function.hpp"

#include <algorithm>

namespace resonform {

namespace {

template <typename Named> const Named* find_named(const std::vector<Named>& all, const std::string& name) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Named& candidate) { return candidate.name == name; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace

const char* to_string(Role role) {
    switch (role) {
    case Role::fast: return "fast";
    case Role::angle: return "angle";
    case Role::slow: return "slow";
    case Role::drift: break;
    }
    return "drift";
}

Place System::place_of(std::size_t variable) const {
    Place place = variables[variable].place;
    if (place.file.empty()) place.file = file.string();
    if (place.key.empty()) place.key = "variables." + variables[variable].name;
    return place;
}

const Variable* System::variable(const std::string& wanted) const { return find_named(variables, wanted); }

std::string System::name_with_settings() const {
    std::string text = name;
    for (std::size_t k = 0; k < settings.size(); ++k)
        text += (k == 0 ? " with " : ", ") + settings[k].parameter + " = " + settings[k].value;
    return text;
}

const Equilibrium* System::equilibrium_of(std::size_t wanted) const {
    const auto found = std::find_if(equilibrium.begin(), equilibrium.end(),
                                    [&](const Equilibrium& at) { return at.variable == wanted; });
    return found == equilibrium.end() ? nullptr : &*found;
}

GiNaC::ex System::small_at(const Rational& value) const {
    return GiNaC::pow(GiNaC::numeric(cln::cl_N(value)), GiNaC::numeric(1, eps_root));
}

const Parameter* System::parameter(const std::string& wanted) const { return find_named(parameters, wanted); }

const Parameter* System::declared_parameter(const std::string& wanted) const {
    const Parameter* used = parameter(wanted);
    return used != nullptr ? used : find_named(cancelled, wanted);
}

const NamedFunction* System::function(const std::string& wanted) const {
    return find_named(functions, wanted);
}

namespace {

struct DataValues : GiNaC::map_function {
    const System& system;

    explicit DataValues(const System& s) : system(s) {}
    GiNaC::ex operator()(const GiNaC::ex& e) override {
        if (!is_named(e)) return e.map(*this);
        const NamedCall call = named_call(e);
        const NamedFunction* function = system.function(call.name);
        if (function == nullptr || function->data == nullptr ||
            !call.argument.info(GiNaC::info_flags::rational))
            return e;
        const Rational at = cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(call.argument).to_cl_N());
        if (!function->data->holds(at)) return e;
        return GiNaC::numeric(cln::cl_N(function->data->at(at, call.derivative)));
    }
};

} // namespace

GiNaC::ex System::with_data(const GiNaC::ex& e) const {
    if (!has_data() || !has_named(e)) return e;
    DataValues values(*this);
    return values(e);
}

bool System::has_data() const {
    return std::any_of(functions.begin(), functions.end(),
                       [](const NamedFunction& f) { return f.data != nullptr; });
}

bool System::has_opaque_functions() const {
    return std::any_of(functions.begin(), functions.end(),
                       [](const NamedFunction& f) { return f.is_opaque(); });
}

std::string System::constant_name(const std::string& kind, const std::string& of) const {
    for (const Notation& entry : notation) {
        if (entry.kind == kind && entry.variable == of) return entry.name;
    }
    return kind + "_" + of;
}

bool Hamiltonian::has(std::size_t variable) const {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const auto& pair) { return pair.first == variable || pair.second == variable; });
}

Scope System::constants() const {
    Scope scope;
    scope.define("eps", GiNaC::pow(eps, eps_root));
    for (const Parameter& p : parameters) scope.define(p.name, p.symbol);
    return scope;
}

void System::define_functions(Scope& scope) const {
    for (const NamedFunction& f : functions)
        if (f.data != nullptr)
            scope.define_data(f.name, f.of, f.data);
        else
            scope.define_function(f.name, f.value);
}

} // namespace resonform
