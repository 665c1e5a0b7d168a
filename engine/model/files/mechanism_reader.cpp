// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/mechanism_reader.hpp"

#include "algebra/number/error.hpp"
#include "model/files/dimension.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/expression.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"
#include "model/text/zero_test.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

constexpr std::size_t most_coordinates = 16;

template <class Named> bool has_name(const std::vector<Named>& all, const std::string& name) {
    return std::any_of(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
}

} // namespace

std::string name_of_integral(const Coordinate& dependent) { return "R_" + dependent.name; }

const std::vector<std::string>& mechanism_tables() {
    static const std::vector<std::string> tables = {
        "coordinates", "prescribed", "quasi_velocities", "particles", "bodies",
        "energy",      "forces",     "constraints",      "integrals", "change"};
    return tables;
}

MechanismReader::MechanismReader(const TomlNode& root, const System& system)
    : root_(root), system_(system), constants_(system.constants()) {
    system.define_functions(constants_);
}

Mechanism MechanismReader::read() {
    read_coordinates();
    read_prescribed();
    read_quasi_velocities();
    read_masses();
    read_energy();
    read_forces();
    read_constraints();
    read_integrals();
    find_fresh();
    read_changes();
    return std::move(mechanism_);
}

template <class Read> void MechanismReader::each(const std::string& key, const Read& read) const {
    const TomlNode* table = root_.find(key);
    if (table == nullptr) return;
    check_table(*table);
    for (const TomlEntry& entry : table->entries) read(entry);
}

// A coordinate that is a variable of the system has the symbols of that variable.
Coordinate MechanismReader::coordinate_of(const TomlEntry& entry) const {
    Coordinate c;
    c.name = entry.key;
    c.place = entry.place;
    if (const Variable* variable = system_.variable(entry.key)) {
        c.unit = variable->unit;
        c.at = variable->jet[0];
        c.velocity = variable->jet[1];
        c.acceleration = variable->jet[2];
        return c;
    }
    c.at = GiNaC::symbol(c.name);
    c.velocity = GiNaC::symbol(c.name + "'");
    c.acceleration = GiNaC::symbol(c.name + "''");
    return c;
}

// A coordinate that is a variable may have its unit in either table.
void MechanismReader::take_unit(Coordinate& c, const TomlEntry& entry) {
    const std::string unit = unit_of(entry.value);
    if (unit.empty()) return;
    const SourceText& source = entry.value.find("unit")->source;
    if (!c.unit.empty() && read_unit(unit, source) != read_unit(c.unit, source))
        bad_input({"the coordinate has two units",
                   in_quotes(unit) + " here, " + in_quotes(c.unit) + " under [variables]",
                   "correct one of the two", place_of(source)});
    c.unit = unit;
}

void MechanismReader::read_coordinates() {
    const TomlNode& table = *root_.find("coordinates");
    mechanism_.source = table.source;
    each("coordinates", [&](const TomlEntry& entry) {
        check_keys(entry.value, {"unit"});
        Coordinate c = coordinate_of(entry);
        take_unit(c, entry);
        mechanism_.coordinates.push_back(std::move(c));
    });
    if (mechanism_.coordinates.empty() || mechanism_.coordinates.size() > most_coordinates)
        bad_input({"a mechanism has 1 ... " + std::to_string(most_coordinates) + " coordinates",
                   std::to_string(mechanism_.coordinates.size()) + " coordinates",
                   "declare them as in x = { unit = \"m\" }", place_of(table.source)});
}

void MechanismReader::read_prescribed() {
    Scope scope = constants_;
    each("prescribed", [&](const TomlEntry& entry) {
        if (system_.variable(entry.key) == nullptr || has_name(mechanism_.coordinates, entry.key))
            bad_input({"what is prescribed is a variable of the system and no coordinate",
                       in_quotes(entry.key),
                       "declare it under [variables] only, as " + entry.key + " = { role = \"slow\" }",
                       entry.place});
        mechanism_.prescribed.push_back({coordinate_of(entry), {}, 0});
        const Coordinate& c = mechanism_.prescribed.back().coordinate;
        scope.define(c.name, c.at);
    });
    std::size_t k = 0;
    each("prescribed", [&](const TomlEntry& entry) {
        Prescribed& p = mechanism_.prescribed[k++];
        Scope own = scope;
        own.define_derivative(p.coordinate.name, 1, p.coordinate.velocity);
        p.law = equation_of(entry.value, own);
        p.rate = rate_of(p);
    });
}

// xi' = eps*v -> eps*v
ex MechanismReader::rate_of(const Prescribed& p) const {
    const ex slope = p.law.value.diff(p.coordinate.velocity);
    if (slope.has(p.coordinate.velocity) || vanishes(slope) != Zero::no)
        bad_input({"what is prescribed is given by its velocity", in_quotes(p.law.text),
                   "write " + p.coordinate.name + "' = ... in prescribed coordinates, parameters and eps",
                   place_of(p.law.source)});
    return -p.law.value.subs(p.coordinate.velocity == 0) / slope;
}

Scope MechanismReader::at_rest() const {
    Scope scope = constants_;
    for (const Coordinate& c : mechanism_.coordinates) scope.define(c.name, c.at);
    for (const Prescribed& p : mechanism_.prescribed) scope.define(p.coordinate.name, p.coordinate.at);
    return scope;
}

Scope MechanismReader::moving() const {
    Scope scope = at_rest();
    for (const Coordinate& c : mechanism_.coordinates) scope.define_derivative(c.name, 1, c.velocity);
    for (const Prescribed& p : mechanism_.prescribed)
        scope.define_derivative(p.coordinate.name, 1, p.coordinate.velocity);
    for (const QuasiVelocity& u : mechanism_.quasi_velocities) scope.define(u.name, u.form.value);
    return scope;
}

Written MechanismReader::part_of(const TomlNode& node, const Scope& scope) {
    mechanism_.parts.push_back({expression_of(node, scope), node.text, node.source});
    return mechanism_.parts.back();
}

Written MechanismReader::equation_of(const TomlNode& node, const Scope& scope) {
    const std::string text = string_of(node);
    mechanism_.parts.push_back({read_equation(text, scope, node.source), text, node.source});
    return mechanism_.parts.back();
}

// A mass or a moment of inertia; zero is allowed, as of a thin rod about itself.
ex MechanismReader::inertia_of(const TomlNode& node, const std::string& what) {
    ex value = part_of(node, constants_).value;
    if (provably_positive(-value, system_)) bad_value(node, what + " is not negative", "correct its sign");
    return value;
}

const TomlNode& MechanismReader::needed(const TomlEntry& entry, const std::string& key) const {
    const TomlNode* node = entry.value.find(key);
    if (node == nullptr)
        bad_input({"a particle needs mass and position, a body inertia besides, and angle or attitude",
                   in_quotes(entry.key) + " has no " + key, "add " + key + " = \"...\"", entry.place});
    return *node;
}

ex MechanismReader::needed(const TomlEntry& entry, const std::string& key, const Scope& scope) {
    return part_of(needed(entry, key), scope).value;
}

Particle MechanismReader::particle_of(const TomlEntry& entry, const std::vector<std::string>& keys) {
    check_keys(entry.value, keys);
    Particle particle{entry.key, inertia_of(needed(entry, "mass"), "a mass"), {}, entry.value.source};
    const TomlNode* position = entry.value.find("position");
    if (position == nullptr || position->type != TomlNode::Type::array ||
        (position->items.size() != 2 && position->items.size() != 3))
        bad_input({"a position is an array of 2 or 3 expressions, in an inertial frame", in_quotes(entry.key),
                   "write position = [\"x\", \"y\", \"z\"]",
                   position == nullptr ? entry.place : place_of(position->source)});
    const Scope scope = at_rest();
    for (const TomlNode& item : position->items) particle.position.push_back(part_of(item, scope).value);
    return particle;
}

void MechanismReader::read_masses() {
    each("particles", [&](const TomlEntry& entry) {
        mechanism_.particles.push_back(particle_of(entry, {"mass", "position"}));
    });
    each("bodies", [&](const TomlEntry& entry) { read_body(entry); });
}

void MechanismReader::read_energy() {
    const TomlNode* energy = root_.find("energy");
    const bool masses = !mechanism_.particles.empty() || !mechanism_.plane_bodies.empty() ||
                        !mechanism_.spatial_bodies.empty();
    if (energy != nullptr) {
        check_keys(*energy, {"potential", "dissipation", "lagrangian"});
        if (const TomlNode* node = energy->find("potential"))
            mechanism_.potential = part_of(*node, at_rest());
        if (const TomlNode* node = energy->find("dissipation"))
            mechanism_.dissipation = part_of(*node, moving());
        if (const TomlNode* node = energy->find("lagrangian"))
            mechanism_.lagrangian = part_of(*node, moving());
        if (mechanism_.lagrangian && (masses || energy->find("potential") != nullptr))
            bad_value(*energy->find("lagrangian"),
                      "a mechanism has a Lagrangian, or particles, bodies and a potential",
                      "leave out one of the two");
    }
    if (!masses && !mechanism_.lagrangian)
        bad_input({"the mechanism has no particles, no bodies and no Lagrangian", "none of them",
                   "describe them under [particles], [bodies] or [energy]", place_of(mechanism_.source)});
}

std::size_t MechanismReader::index_of(const TomlEntry& entry, const std::string& what) const {
    const std::vector<Coordinate>& all = mechanism_.coordinates;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Coordinate& c) { return c.name == entry.key; });
    if (found != all.end()) return static_cast<std::size_t>(found - all.begin());
    std::vector<std::string> names;
    for (const Coordinate& c : all) names.push_back(c.name);
    bad_input(Reason::name, {what + " belongs to a coordinate", in_quotes(entry.key),
                             suggest(entry.key, names), entry.place});
}

void MechanismReader::read_forces() {
    each("forces", [&](const TomlEntry& entry) {
        if (add_force_on_quasi_velocity(entry)) return;
        const std::size_t at = index_of(entry, "a generalised force");
        mechanism_.forces.push_back({at, part_of(entry.value, moving()).value, entry.value.source});
    });
}

void MechanismReader::read_constraints() {
    each("constraints", [&](const TomlEntry& entry) {
        mechanism_.constraints.push_back({entry.key, equation_of(entry.value, moving())});
    });
}

void MechanismReader::read_integrals() {
    each("integrals", [&](const TomlEntry& entry) {
        mechanism_.integrals.push_back({coordinate_of(entry), part_of(entry.value, at_rest())});
    });
}

// Finds the variables that [change] brings in: no coordinates, quasi-velocities, prescribed ones or
// integrals, not even by the name of an integral that the engine may find.
void MechanismReader::find_fresh() {
    const TomlNode* variables = root_.find("variables");
    const auto named_by_engine = [&](const std::string& name) {
        return std::any_of(mechanism_.coordinates.begin(), mechanism_.coordinates.end(),
                           [&](const Coordinate& c) { return name == name_of_integral(c); });
    };
    for (const TomlEntry& entry : variables->entries) {
        const bool known = has_name(mechanism_.coordinates, entry.key) || named_by_engine(entry.key) ||
                           has_name(mechanism_.quasi_velocities, entry.key) ||
                           std::any_of(mechanism_.prescribed.begin(), mechanism_.prescribed.end(),
                                       [&](const Prescribed& p) { return p.coordinate.name == entry.key; }) ||
                           std::any_of(mechanism_.integrals.begin(), mechanism_.integrals.end(),
                                       [&](const Integral& i) { return i.coordinate.name == entry.key; });
        if (!known) mechanism_.fresh.push_back(coordinate_of(entry));
    }
}

void MechanismReader::read_changes() {
    const TomlNode* table = root_.find("change");
    if (table == nullptr) return;
    Scope scope = constants_;
    for (const Coordinate& c : mechanism_.coordinates)
        if (table->find(c.name) == nullptr) scope.define(c.name, c.at);
    for (const Coordinate& c : mechanism_.fresh) scope.define(c.name, c.at);
    for (const Integral& i : mechanism_.integrals) scope.define(i.coordinate.name, i.coordinate.at);
    for (const Prescribed& p : mechanism_.prescribed) scope.define(p.coordinate.name, p.coordinate.at);
    each("change", [&](const TomlEntry& entry) {
        mechanism_.changes.push_back({index_of(entry, "a change of variables"), part_of(entry.value, scope)});
    });
}

} // namespace resonform
