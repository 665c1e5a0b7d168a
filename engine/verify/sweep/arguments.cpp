// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/arguments.hpp"

#include "algebra/number/error.hpp"
#include "model/system/scene_file.hpp"
#include "model/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

[[noreturn]] void bad_axis(Reason reason, const std::string& rule, const std::string& found,
                           const std::string& hint) {
    bad_input(reason, {rule, found, hint, {}});
}

// The name that the system gives to a start value "amplitude.psi", or this itself.
std::string name_of_start(const System& system, const std::string& canonical) {
    for (const Notation& n : system.notation)
        if (n.kind + "." + n.variable == canonical) return n.name;
    return canonical;
}

// The arguments of the program as a user calls them: eps, the parameters, the start values.
std::vector<std::string> argument_names(const Program& program, const System& system) {
    std::vector<std::string> names{"eps"};
    for (const ProgramInput& p : program.parameters) names.push_back(p.name);
    for (const ProgramInput& s : program.start) names.push_back(name_of_start(system, s.canonical));
    return names;
}

std::size_t place_of_axis(const std::string& name, const Program& program, const Scene& scene) {
    const std::vector<std::string> names = argument_names(program, *scene.system);
    for (std::size_t k = 0; k < names.size(); ++k)
        if (names[k] == name || (k > program.parameters.size() &&
                                 program.start[k - 1 - program.parameters.size()].canonical == name))
            return k;
    const auto& parameters = scene.system->parameters;
    const bool known =
        std::any_of(parameters.begin(), parameters.end(), [&](const auto& p) { return p.name == name; }) ||
        std::any_of(scene.start.begin(), scene.start.end(), [&](const auto& s) { return s.name == name; });
    if (known)
        bad_axis(Reason::name, "an axis must be something that the outputs depend on", name,
                 "leave it out: they do not depend on it");
    bad_axis(Reason::name, "an axis must be eps, a parameter or a start value of the scene", name,
             suggest(name, names));
}

} // namespace

std::vector<std::size_t> places_of_axes(const SweepGrid& grid, const Program& program, const Scene& scene) {
    std::vector<std::size_t> places;
    for (const Axis& axis : grid.axes()) {
        places.push_back(place_of_axis(axis.name(), program, scene));
        if (std::count(places.begin(), places.end(), places.back()) > 1)
            bad_axis(Reason::name, "each argument must be given once", axis.name(),
                     "leave it out: another axis is the same by another name");
    }
    std::vector<std::string> missing;
    for (std::size_t k = 0; k < program.parameters.size(); ++k)
        if (program.parameters[k].default_value < 0 &&
            std::find(places.begin(), places.end(), k + 1) == places.end())
            missing.push_back(program.parameters[k].name);
    if (!missing.empty())
        not_fixed(scene, "a sweep needs an axis or a value for every parameter that the outputs depend on",
                  missing);
    return places;
}

std::string canonical_name(const Program& program, std::size_t place) {
    if (place == 0) return "eps";
    const std::size_t parameters = program.parameters.size();
    return place <= parameters ? program.parameters[place - 1].name
                               : program.start[place - 1 - parameters].canonical;
}

GivenArguments arguments_at(const SweepGrid& grid, std::uint64_t i, const Program& program,
                            const std::vector<std::size_t>& places) {
    const std::vector<double> point = grid.point(i);
    GivenArguments given;
    for (std::size_t a = 0; a < places.size(); ++a) given[canonical_name(program, places[a])] = point[a];
    return given;
}

void require_axes(const SweepGrid& grid, const Scene& scene) {
    bool has_eps = false;
    for (const Axis& axis : grid.axes()) {
        if (scene.fix.count(axis.name()) > 0)
            bad_axis(Reason::name, "an axis must not be a parameter that [fix] gives a value", axis.name(),
                     "take it out of [fix], which folds it into the code");
        if (axis.name() != "eps") continue;
        has_eps = true;
        if (axis.least() < smallest_eps || axis.largest() > largest_eps)
            bad_axis(Reason::command_line,
                     std::string(eps_rule) + ", where the expansion in eps has a meaning",
                     fmt::format("{} ... {}", axis.least(), axis.largest()), "give for example eps=0.01");
    }
    if (!has_eps)
        bad_axis(Reason::command_line, "one of the axes must be eps", "none",
                 "give it one value at least: --over eps=0.01");
}

} // namespace resonform
