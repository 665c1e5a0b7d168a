// SPDX-License-Identifier: GPL-3.0-or-later
// From the tree of a system.toml to a checked System, table by table.
#pragma once

#include "model/system/system_file.hpp"
#include "model/text/toml_tree.hpp"

#include <map>
#include <memory>

namespace resonform {

struct ChangeOfEquations;
struct Coordinate;
struct FunctionValues;
struct GivenRelation;

class SystemReader {
public:
    // nullptr: functions are known by their names only. What it points to outlives the reader.
    SystemReader(TomlNode root, const std::filesystem::path& file, const FunctionValues* values = nullptr);
    // `early` are put in before the equilibrium is proved or found; what names no parameter is left out.
    System read(const std::vector<Setting>& early = {}, const std::string& option = "");

private:
    void read_header();
    void read_parameters();
    void read_variables();
    void read_functions();
    void give_values();             // to the functions (functions_reader.cpp)
    void check_given_signs() const; // what is declared of a function holds of its value
    void read_pairs();              // of a Hamiltonian, whose variables need no equations
    [[nodiscard]] bool is_mechanism() const;
    void require_coordinates() const; // if there are other tables of a mechanism
    void derive_equations();          // of a mechanism (mechanism_system.cpp)
    void take_constant(const Coordinate& constant, Role role);
    [[nodiscard]] bool changes_variables() const; // of equations, not of a mechanism
    void require_equations_to_change() const;
    void change_equations(); // (change_reader.cpp)
    [[nodiscard]] Variable replaced_variable(const TomlEntry& entry);
    [[nodiscard]] std::vector<Variable> variables_before(const std::vector<std::string>& fresh);
    void take_symbols(const std::vector<Variable>& before);
    [[nodiscard]] ChangeOfEquations change_from(System before) const;
    void make_parameter(const std::string& name);
    void check_roles() const;
    void drop_cancelled();      // parameters that the derived equations do not hold
    void read_equation_texts(); // one per variable; finds the order of each variable
    void set_orders();
    void read_equations();
    void read_energy(); // completes the equations, checks those that were given
    void read_domain();
    [[nodiscard]] std::vector<GivenRelation> relation_values() const;
    void read_relations();   // puts the values into equations and domain
    void read_modes();       // modes_reader.cpp
    void read_equilibrium(); // equilibrium_reader.cpp
    void put_in(const std::vector<Setting>& early, const std::string& option);
    void settle_equilibrium(); // checked or solved for, in the equations as they are in the end
    void scale_small_parameters();
    void refine_weights(); // to integers, with a root of eps
    [[nodiscard]] GiNaC::ex at_rest(const GiNaC::ex& e) const;
    [[nodiscard]] GiNaC::ex regular_at_rest(const GiNaC::ex& e, const TomlNode& value) const;
    void read_normal_form();
    void read_notation();
    void check_names_of_results() const;

    Variable variable_of(const TomlEntry& entry);
    [[nodiscard]] std::size_t canonical_variable(const std::string& name, const TomlNode& node,
                                                 const Place& place) const;
    [[nodiscard]] bool is_canonical(const Variable& variable) const; // one of a pair
    void check_canonical(const Equation& equation, const GiNaC::exmap& rates) const;
    [[nodiscard]] std::string argument_of(const TomlEntry& entry) const; // of a function
    void require_slow_argument(const NamedFunction& function, const TomlNode& node,
                               const std::string& what) const;
    void read_callable(NamedFunction& function, const TomlNode& node) const;
    void read_data(NamedFunction& function, const TomlNode& node) const;
    [[nodiscard]] FunctionValue value_of(const NamedFunction& function, const TomlNode& node) const;
    void check_order(const Variable& variable, int highest) const;
    [[nodiscard]] const TomlNode& table(const std::string& key, const std::string& hint) const;
    // Refuses reserved and ill-formed names and those that are taken.
    void claim_name(const TomlEntry& entry, const std::string& what);
    [[nodiscard]] std::vector<std::string> variable_names() const;

    TomlNode root_;
    const FunctionValues* values_;
    System system_;
    std::vector<std::pair<GiNaC::symbol, Rational>> small_; // parameters of positive weight
    std::vector<Rational> weights_;                         // of the variables
    std::vector<std::string> undecided_;                    // variables of a mechanism without a role
    std::shared_ptr<Derivation> derivation_;                // of a mechanism, or by a change of variables
    std::map<std::string, std::string> taken_;              // name -> the kind of thing that has it
};

} // namespace resonform
