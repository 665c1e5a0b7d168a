// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/system_reader.hpp"

#include "algebra/number/error.hpp"
#include "model/files/dimension.hpp"
#include "model/files/heading.hpp"
#include "model/files/settings.hpp"
#include "model/system/names.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/eps_powers.hpp"
#include "model/text/expression.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"

#include <algorithm>

namespace resonform {

namespace {

constexpr int most_variables = 64;
constexpr int most_parameters = 30; // the coefficient ring has room for 32 with i and eps
constexpr int most_functions = 30;
constexpr int most_primes = 9;

// Refuses a list that no honest system has.
void check_count(const TomlNode& table, int most) {
    if (table.entries.size() > static_cast<std::size_t>(most)) {
        bad_input({"[" + table.source.key + "] has at most " + std::to_string(most) + " entries",
                   std::to_string(table.entries.size()) + " entries", "describe a smaller system",
                   place_of(table.source)});
    }
}

bool flag(const TomlNode& table, const std::string& key) {
    const TomlNode* node = table.find(key);
    return node != nullptr && boolean_of(*node);
}

bool nonzero_of(const TomlNode& table, bool positive) {
    const TomlNode* given = table.find("nonzero");
    const bool nonzero = flag(table, "nonzero");
    if (positive && given != nullptr && !nonzero)
        bad_value(*given, "what is positive is not zero", "remove nonzero = false, or positive = true");
    return positive || nonzero;
}

Role role_of(const TomlEntry& entry) {
    const TomlNode* node = entry.value.find("role");
    if (node == nullptr) {
        bad_input({"the variable has no role", in_quotes(entry.key),
                   "write role = \"fast\", \"angle\", \"slow\" or \"drift\"", entry.place});
    }
    const std::string role = string_of(*node);
    if (role == "fast") return Role::fast;
    if (role == "slow") return Role::slow;
    if (role == "drift") return Role::drift;
    if (role == "angle") return Role::angle;
    bad_value(*node, "unknown role: the roles are fast, angle, slow and drift",
              suggest(role, {"fast", "angle", "slow", "drift"}));
}

// A fast variable is of the size of eps^weight.
Rational weight_of(const TomlNode& table, Role role) {
    const TomlNode* node = table.find("weight");
    const Rational standard = role == Role::fast ? 1 : 0;
    if (node == nullptr) return standard;
    const Rational weight = weight_of(*node);
    if (role != Role::fast && weight != standard)
        refuse({"the weight of a variable that is not fast is 0", excerpt(node->text),
                "remove the key, or scale the variable", place_of(node->source)});
    return weight;
}

} // namespace

SystemReader::SystemReader(TomlNode root, const std::filesystem::path& file, const FunctionValues* values)
    : root_(std::move(root)), values_(values) {
    system_.file = file;
}

System SystemReader::read(const std::vector<Setting>& early, const std::string& option) {
    read_header();
    require_coordinates();
    require_equations_to_change();
    read_parameters();
    read_variables();
    read_functions();
    give_values();
    read_pairs();
    if (is_mechanism())
        derive_equations();
    else if (changes_variables())
        change_equations();
    else
        read_equation_texts();
    set_orders();
    read_equations();
    read_energy();
    read_domain();
    check_given_signs();
    read_modes();
    read_equilibrium();
    read_relations();
    drop_cancelled();
    scale_small_parameters();
    refine_weights();
    put_in(early, option);
    settle_equilibrium();
    read_normal_form();
    read_notation();
    check_names_of_results();
    return std::move(system_);
}

void SystemReader::put_in(const std::vector<Setting>& early, const std::string& option) {
    std::vector<Setting> known;
    for (const Setting& setting : early)
        if (system_.declared_parameter(setting.parameter) != nullptr) known.push_back(setting);
    if (!known.empty()) system_ = with_settings(std::move(system_), known, option);
}

void SystemReader::read_header() {
    const Heading heading = heading_of_system(root_, system_.file);
    system_.name = heading.name;
    system_.name_place = heading.name_place;
    system_.title = heading.title;
    system_.source = heading.source;
}

void SystemReader::read_parameters() {
    const TomlNode* parameters = root_.find("parameters");
    if (parameters == nullptr) return;
    check_table(*parameters);
    check_count(*parameters, most_parameters);
    for (const TomlEntry& entry : parameters->entries) {
        claim_name(entry, "a parameter");
        check_keys(entry.value, {"positive", "nonzero", "unit", "weight"});
        Parameter parameter;
        parameter.name = entry.key;
        parameter.place = entry.place;
        parameter.positive = flag(entry.value, "positive");
        parameter.nonzero = nonzero_of(entry.value, parameter.positive);
        parameter.unit = unit_of(entry.value);
        parameter.symbol = GiNaC::symbol(parameter.name);
        const TomlNode* weight = entry.value.find("weight");
        if (weight != nullptr && !cln::zerop(weight_of(*weight)))
            small_.emplace_back(parameter.symbol, weight_of(*weight));
        system_.parameters.push_back(std::move(parameter));
    }
}

void SystemReader::read_variables() {
    const TomlNode& variables = table("variables", "declare them under [variables]");
    check_count(variables, most_variables);
    for (const TomlEntry& entry : variables.entries) {
        claim_name(entry, "a variable");
        system_.variables.push_back(variable_of(entry));
    }
    if (system_.variables.empty()) {
        bad_input({"the system has no variable", "[variables]", "declare one as in x = { role = \"fast\" }",
                   place_of(variables.source)});
    }
}

// omega = { of = ["tau"], positive = true }
void SystemReader::read_functions() {
    const TomlNode* functions = root_.find("functions");
    if (functions == nullptr) return;
    check_table(*functions);
    check_count(*functions, most_functions);
    for (const TomlEntry& entry : functions->entries) {
        claim_name(entry, "a function");
        check_keys(entry.value, {"of", "positive", "nonzero"});
        NamedFunction function;
        function.name = entry.key;
        function.of = argument_of(entry);
        function.positive = flag(entry.value, "positive");
        function.nonzero = nonzero_of(entry.value, function.positive);
        system_.functions.push_back(std::move(function));
    }
}

Variable SystemReader::variable_of(const TomlEntry& entry) {
    check_keys(entry.value, {"role", "unit", "positive", "nonzero", "weight"});
    Variable variable;
    variable.name = entry.key;
    variable.place = entry.place;
    if (is_mechanism() && entry.value.find("role") == nullptr) {
        variable.role = Role::drift; // for the time being
        undecided_.push_back(variable.name);
    } else {
        variable.role = role_of(entry);
    }
    weights_.push_back(weight_of(entry.value, variable.role));
    variable.unit = unit_of(entry.value);
    for (const std::string key : {"positive", "nonzero"}) {
        const TomlNode* node = entry.value.find(key);
        const bool undecided = !undecided_.empty() && undecided_.back() == variable.name;
        if (node == nullptr || variable.role == Role::slow || undecided) continue;
        bad_input({"a variable that is not slow is declared positive or nonzero",
                   in_quotes(entry.key) + " is " + to_string(variable.role), "remove the key",
                   place_of(node->source)});
    }
    variable.positive = flag(entry.value, "positive");
    variable.nonzero = nonzero_of(entry.value, variable.positive);
    return variable;
}

void SystemReader::read_equation_texts() {
    static const TomlNode none;
    const bool derived = std::all_of(system_.variables.begin(), system_.variables.end(),
                                     [&](const Variable& v) { return is_canonical(v); });
    const TomlNode& equations = derived && root_.find("equations") == nullptr
                                    ? none
                                    : table("equations", "write one equation per variable under [equations]");
    for (const TomlEntry& entry : equations.entries) {
        if (system_.variable(entry.key) != nullptr) continue;
        bad_input(Reason::name, {"an equation belongs to no variable", in_quotes(entry.key),
                                 suggest(entry.key, variable_names()), entry.place});
    }
    for (const Variable& variable : system_.variables) {
        const TomlNode* node = equations.find(variable.name);
        if (node == nullptr && is_canonical(variable)) {
            system_.equations.push_back({variable.name, "", 0, system_.hamiltonian->source});
            continue; // read_energy() derives it
        }
        if (node == nullptr) {
            bad_input({"the variable has no equation", in_quotes(variable.name),
                       "write " + variable.name + " = \"" + variable.name + "' = ...\" under [equations]",
                       variable.place});
        }
        Equation equation;
        equation.variable = variable.name;
        equation.text = string_of(*node);
        equation.source = node->source;
        if (equation.text.find_first_not_of(" \t\r\n") == std::string::npos)
            bad_value(*node, "the equation is empty",
                      is_canonical(variable) ? "write it, or leave the key out: it follows from the energy"
                                             : "write it as " + variable.name + "' = ...");
        system_.equations.push_back(std::move(equation));
    }
}

void SystemReader::set_orders() {
    std::map<std::string, int> highest;
    for (const Variable& variable : system_.variables)
        if (is_canonical(variable)) highest[variable.name] = 1;
    for (const Equation& equation : system_.equations) {
        for (const auto& [name, primes] : highest_primes(equation.text, equation.source)) {
            highest[name] = std::max(highest[name], primes);
        }
    }
    for (Variable& variable : system_.variables) {
        check_order(variable, highest[variable.name]);
        variable.order = highest[variable.name];
        for (int k = 0; k <= variable.order; ++k) {
            variable.jet.emplace_back(variable.name + std::string(static_cast<std::size_t>(k), '\''));
        }
    }
}

void SystemReader::check_order(const Variable& variable, int highest) const {
    const std::string found = in_quotes(variable.name) + " with " + std::to_string(highest) + " primes";
    if (highest > 1 && is_canonical(variable))
        bad_input({"the equation of a canonical variable is not of first order", found,
                   "leave it out: it follows from the energy", variable.place});
    if (highest == 0) {
        bad_input({"the derivative of the variable does not occur in the equations",
                   "no " + variable.name + "' in any equation",
                   "write its equation with " + variable.name + "', or make it a parameter", variable.place});
    }
    if (highest > most_primes) {
        bad_input({"a variable has at most " + std::to_string(most_primes) + " primes", found,
                   "write a system of lower order", variable.place});
    }
    if (variable.role != Role::fast && highest > 1) {
        bad_input({std::string(variable.role == Role::angle ? "an " : "a ") + to_string(variable.role) +
                       " variable has an equation of first order",
                   found, "make it fast, or declare its derivative as a variable", variable.place});
    }
}

void SystemReader::read_equations() {
    Scope scope = system_.constants();
    system_.define_functions(scope);
    for (const Variable& variable : system_.variables) {
        for (int k = 0; k <= variable.order; ++k) {
            scope.define_derivative(variable.name, k, variable.jet[static_cast<std::size_t>(k)]);
        }
    }
    for (Equation& equation : system_.equations) {
        if (equation.text.empty() && is_canonical(*system_.variable(equation.variable))) continue;
        equation.residual = read_equation(equation.text, scope, equation.source);
    }
}

const TomlNode& SystemReader::table(const std::string& key, const std::string& hint) const {
    const TomlNode* node = root_.find(key);
    if (node == nullptr) {
        bad_input({"the system file has no table [" + key + "]", "no [" + key + "]", hint,
                   whole_file(system_.file)});
    }
    check_table(*node);
    return *node;
}

void SystemReader::claim_name(const TomlEntry& entry, const std::string& what) {
    if (!is_identifier(entry.key)) {
        bad_input({identifier_rule(what + "'s name"), excerpt(entry.key), identifier_hint(), entry.place});
    }
    if (is_reserved(entry.key)) {
        bad_input({"the name of " + what + " is not a reserved one", entry.key,
                   "choose another; reserved are I, pi, E, eps, lambda, t, z1, z2, ..., the functions, and "
                   "the words of Python and SymPy",
                   entry.place});
    }
    const auto [earlier, is_new] = taken_.emplace(entry.key, what);
    if (!is_new) {
        bad_input({"the name is used twice", in_quotes(entry.key) + " is " + earlier->second + " already",
                   "rename one of the two", entry.place});
    }
}

std::vector<std::string> SystemReader::variable_names() const {
    std::vector<std::string> names;
    for (const Variable& variable : system_.variables) names.push_back(variable.name);
    return names;
}

} // namespace resonform
