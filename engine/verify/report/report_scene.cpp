// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "emit/derive/document.hpp"
#include "model/text/canonical.hpp"
#include "verify/report/page.hpp"
#include "verify/report/sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <string>
#include <vector>

namespace resonform::report {

namespace {

// "g = 1 m/s²"; "g (m/s²): free"
std::string value_of(const Scene& scene, const Parameter& parameter) {
    const std::string unit = parameter.unit.empty() ? "" : " " + typeset(parameter.unit);
    const auto fixed = scene.fix.find(parameter.name);
    if (fixed == scene.fix.end()) return fmt::format("{} free", pretty(parameter.name));
    return fmt::format("{} = {}{}", pretty(parameter.name), typeset(spell(fixed->second)), unit);
}

std::string values_of(const std::vector<std::pair<std::string, std::string>>& named) {
    std::vector<std::string> values;
    for (const auto& [name, text] : named)
        values.push_back(fmt::format("{} = {}", pretty(name), typeset(text)));
    return fmt::format("{}", fmt::join(values, ", "));
}

std::string ladder_of(const Verification& verification) {
    std::vector<std::string> eps;
    if (!verification.outputs.empty())
        for (const LadderRung& rung : verification.outputs.front().ladder)
            eps.push_back(plain_number(to_double(rung.eps)));
    return fmt::format("{}", fmt::join(eps, ", "));
}

std::string machine_of(const Machine& m) {
    return fmt::format("{}, {} processor{}; {}; loops for many points: {}", m.processor, m.processors,
                       m.processors == 1 ? "" : "s", m.instructions, m.loops);
}

std::string times_of(const Conditions& c) {
    std::string text = fmt::format("{} at the smallest ε, half of them even", c.count);
    if (std::isfinite(c.first)) text += fmt::format(", the first at t = {}", short_number(c.first));
    if (std::isfinite(c.per_fast_period))
        text += fmt::format("; at least {} to a fast period", short_number(c.per_fast_period));
    return text;
}

Facts facts_of(const Findings& f, const Figures& figures) {
    const Scene& scene = *f.scene;
    const Conditions& c = f.verification.conditions;
    Facts facts;
    const auto add = [&](const char* name, const std::string& value) {
        if (!value.empty()) facts.all.emplace_back(name, value);
    };
    std::vector<std::string> parameters;
    for (const Parameter& p : scene.system->parameters) parameters.push_back(value_of(scene, p));
    std::vector<std::string> outputs;
    for (const std::string& name : scene.outputs) outputs.push_back(figures.label(name));
    add("parameters", fmt::format("{}", fmt::join(parameters, ", ")));
    add("functions", values_of(c.functions));
    add("start", values_of(c.start));
    add("outputs", fmt::format("{}", fmt::join(outputs, "; ")));
    const std::string unit = figures.unit_of_time();
    add("interval", interval_of(c) + (unit.empty() ? "" : ", " + unit));
    add("values of ε", ladder_of(f.verification));
    if (c.count > 0) add("times compared", times_of(c));
    return facts;
}

Facts facts_of(const Origin& origin) {
    return {{{"command", origin.command},
             {"date", origin.date},
             {"program", fmt::format("resonform {}, commit {}", origin.version, origin.commit)},
             {"compiler", origin.machine.compiler},
             {"machine", machine_of(origin.machine)}}};
}

} // namespace

Section scene_section(const Findings& f, const Figures& figures) {
    const System& system = *f.scene->system;
    return {"System and scene",
            {Formulas{print_equations(system, Format::latex), print_equations(system, Format::text)},
             facts_of(f, figures), Paragraph{"Made by:"}, facts_of(f.origin)}};
}

} // namespace resonform::report
