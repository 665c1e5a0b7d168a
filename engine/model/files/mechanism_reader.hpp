// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a system.toml that describe a mechanism.
#pragma once

#include "model/system/mechanism.hpp"
#include "model/text/toml_tree.hpp"

namespace resonform {

// The tables that a file with [coordinates] may have besides those of every system.
const std::vector<std::string>& mechanism_tables();

class MechanismReader {
public:
    // `system` has its parameters, functions, and variables with at least three symbols in each jet.
    MechanismReader(const TomlNode& root, const System& system);
    // Errors: bad_input: a rule of the format is broken.
    Mechanism read();

private:
    void read_coordinates();
    void read_prescribed();
    void read_quasi_velocities();
    void read_integrals();
    void find_fresh();
    void read_masses();
    void read_energy();
    void read_forces();
    bool add_force_on_quasi_velocity(const TomlEntry& entry); // false: it belongs to none
    void read_constraints();
    void read_changes();

    static void take_unit(Coordinate& coordinate, const TomlEntry& entry);
    [[nodiscard]] Coordinate coordinate_of(const TomlEntry& entry) const;
    Particle particle_of(const TomlEntry& entry, const std::vector<std::string>& keys);
    void read_body(const TomlEntry& entry);
    [[nodiscard]] const std::vector<TomlNode>& three(const TomlEntry& entry, const std::string& key) const;
    // Of Euler's angles, along the axes of the body.
    [[nodiscard]] std::vector<GiNaC::ex> spin_of(const std::vector<GiNaC::ex>& angles) const;
    [[nodiscard]] GiNaC::ex rate_of(const GiNaC::ex& position) const;
    // An expression, and an equation lhs - rhs, among the parts of the mechanism.
    Written part_of(const TomlNode& node, const Scope& scope);
    Written equation_of(const TomlNode& node, const Scope& scope);
    GiNaC::ex inertia_of(const TomlNode& node, const std::string& what);
    [[nodiscard]] const TomlNode& needed(const TomlEntry& entry, const std::string& key) const;
    GiNaC::ex needed(const TomlEntry& entry, const std::string& key, const Scope& scope);
    [[nodiscard]] std::size_t index_of(const TomlEntry& entry, const std::string& what) const;
    [[nodiscard]] GiNaC::ex rate_of(const Prescribed& prescribed) const;
    // Calls read(entry) for each entry of a table, if there is one.
    template <class Read> void each(const std::string& key, const Read& read) const;
    [[nodiscard]] Scope at_rest() const; // coordinates, prescribed ones, constants
    [[nodiscard]] Scope moving() const;  // and velocities

    const TomlNode& root_;
    const System& system_;
    Scope constants_;
    Mechanism mechanism_;
};

} // namespace resonform
