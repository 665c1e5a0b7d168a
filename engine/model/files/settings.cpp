// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/settings.hpp"

#include "algebra/number/error.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/expression.hpp"
#include "model/text/nearest.hpp"
#include "model/text/regular.hpp"
#include "model/text/zero_test.hpp"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;

[[noreturn]] void complain(const std::string& rule, const std::string& value, const std::string& hint,
                           const std::string& option) {
    Place place;
    place.key = option;
    bad_input(Reason::command_line, {rule, value, hint, place});
}

// Errors show the word NAME=VALUE, and count columns in it.
ex read_value(const Setting& setting, const std::string& option) {
    SourceText source;
    source.key = option;
    source.column = static_cast<int>(setting.parameter.size()) + 2;
    source.source_line = printable(setting.parameter + "=" + setting.value);
    try {
        return read_expression(setting.value, Scope(), source);
    } catch (const Error& error) {
        Diagnostic d = error.diagnostic();
        d.value = excerpt(source.source_line);
        throw Error(error.kind(), std::move(d));
    }
}

// Refuses a constant whose sign interval arithmetic does not decide.
[[noreturn]] void refuse_undecided(const std::string& value, const std::string& option) {
    Place place;
    place.key = option;
    refuse(Reason::undecided, {"the sign of a value is decided by intervals", value + " may be zero",
                               "write the value in a simpler form", place});
}

void check_value(const Setting& setting, const Parameter& parameter, const ex& value,
                 const std::string& option) {
    if (!parameter.positive && !parameter.nonzero) return;
    const std::string found = setting.parameter + "=" + setting.value;
    const ConstantSign sign = sign_of_constant(value);
    if (sign == ConstantSign::positive || (sign == ConstantSign::negative && !parameter.positive)) return;
    if (sign == ConstantSign::unknown && vanishes(value) == Zero::unknown) refuse_undecided(found, option);
    complain("the file declares " + parameter.name + (parameter.positive ? " positive" : " nonzero"), found,
             "set a value of this kind, or change the file", option);
}

// Refuses --set of a parameter that [relations] computes.
void refuse_related(const System& system, const std::string& parameter, const std::string& option) {
    for (const ParameterRelation& relation : system.relations)
        if (relation.parameter == parameter)
            complain("a parameter computed by [relations] is given a value of its own",
                     parameter + " = " + relation.text,
                     "set the parameters on the right side, or take the relation from line " +
                         std::to_string(relation.source.line) + " of the file",
                     option);
}

// A declared expression that has become a number must be positive.
void put_into_domain(System& system, const GiNaC::exmap& values, const std::string& option) {
    std::vector<Declaration> rest;
    for (Declaration& declaration : system.positive) {
        declaration.value = declaration.value.subs(values, GiNaC::subs_options::no_pattern);
        if (!is_constant(declaration.value)) {
            rest.push_back(std::move(declaration));
            continue;
        }
        const ConstantSign sign = sign_of_constant(declaration.value);
        if (sign == ConstantSign::positive) continue;
        if (sign == ConstantSign::unknown && vanishes(declaration.value) == Zero::unknown)
            refuse_undecided(in_quotes(declaration.text), option);
        complain("line " + std::to_string(declaration.source.line) +
                     " of the file declares positive what these values make zero or negative",
                 in_quotes(declaration.text), "set values for which it is positive", option);
    }
    system.positive = std::move(rest);
}

// Errors (bad_input): a pole at the values.
void put_regularly(ex& e, const GiNaC::exmap& values, const Place& place, const std::string& option) {
    const auto value = where_regular([&] { return e.subs(values, GiNaC::subs_options::no_pattern); });
    if (!value)
        bad_input({"the values of " + option + " make no denominator zero, and no logarithm one of zero",
                   in_quotes(spell(e)), "set other values", place});
    e = *value;
}

} // namespace

Setting read_setting(const std::string& text, const std::string& option) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        complain("the setting is not NAME=VALUE", printable(text), "write for example g=1 or r=4/5", option);
    return {text.substr(0, equals), text.substr(equals + 1)};
}

System with_settings(System system, const std::vector<Setting>& settings, const std::string& option) {
    GiNaC::exmap values;
    for (const Setting& setting : settings) {
        const Parameter* parameter = system.declared_parameter(setting.parameter);
        if (parameter == nullptr) {
            refuse_related(system, setting.parameter, option);
            std::vector<std::string> known;
            for (const auto* list : {&system.parameters, &system.cancelled})
                for (const Parameter& p : *list) known.push_back(p.name);
            complain("the setting does not name a parameter of the system", in_quotes(setting.parameter),
                     suggest(setting.parameter, known), option);
        }
        const ex value = read_value(setting, option);
        check_value(setting, *parameter, value, option);
        if (!values.emplace(parameter->symbol, value).second)
            complain("the parameter is set twice", in_quotes(setting.parameter), "leave out one of them",
                     option);
    }
    put_into_domain(system, values, option);
    const auto put_into = [&](ex& e, const Place& place) { put_regularly(e, values, place, option); };
    for (Equation& equation : system.equations) put_into(equation.residual, place_of(equation.source));
    if (system.hamiltonian) put_into(system.hamiltonian->energy, place_of(system.hamiltonian->source));
    const auto put_into_number = [&](GivenNumber& number) {
        put_into(number.re, place_of(number.source));
        put_into(number.im, place_of(number.source));
    };
    for (GivenMode& mode : system.modes) {
        put_into_number(mode.eigenvalue);
        for (GivenMode::Entry& entry : mode.column) put_into_number(entry.value);
    }
    for (Equilibrium& at : system.equilibrium) put_into(at.value, place_of(at.source));
    for (NamedFunction& f : system.functions)
        if (f.value) put_into(f.value->value, {system.file.string(), 0, 0, "functions." + f.name, ""});
    const auto is_set = [&](const Parameter& p) { return values.count(p.symbol) != 0; };
    system.settings.insert(system.settings.end(), settings.begin(), settings.end());
    system.parameters.erase(std::remove_if(system.parameters.begin(), system.parameters.end(), is_set),
                            system.parameters.end());
    return system;
}

bool is_set(const System& system, const std::string& parameter) {
    return std::any_of(system.settings.begin(), system.settings.end(),
                       [&](const Setting& setting) { return setting.parameter == parameter; });
}

std::shared_ptr<const System> system_with_fix(const Scene& scene) {
    std::vector<Setting> settings;
    for (const Parameter& p : scene.system->parameters)
        if (const auto fixed = scene.fix.find(p.name); fixed != scene.fix.end())
            settings.push_back({p.name, spell(fixed->second)});
    return std::make_shared<const System>(with_settings(*scene.system, settings, "[fix]"));
}

Scene with_fix_put_in(Scene scene) {
    for (StartValue& start : scene.start) start.value = scene.fixed(start.value);
    scene.verify.interval = scene.fixed(scene.verify.interval);
    scene.system = system_with_fix(scene);
    return scene;
}

} // namespace resonform
