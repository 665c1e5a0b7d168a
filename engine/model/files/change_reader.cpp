// SPDX-License-Identifier: GPL-3.0-or-later
// [change] beside [equations]: these are read in the old variables, and written in the new ones.
#include "algebra/number/error.hpp"
#include "model/files/system_reader.hpp"
#include "model/mechanics/changed_equations.hpp"
#include "model/mechanics/derivation.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/toml_values.hpp"

#include <algorithm>

namespace resonform {

namespace {

std::string names_of(const std::vector<std::string>& all) {
    std::string text;
    for (const std::string& name : all) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

} // namespace

bool SystemReader::changes_variables() const { return !is_mechanism() && root_.find("change") != nullptr; }

void SystemReader::require_equations_to_change() const {
    const TomlNode* node = root_.find("hamiltonian");
    if (node == nullptr || !changes_variables()) return;
    refuse({"a change of variables is one of equations: of an energy it would have to be canonical",
            "[change] beside [hamiltonian]",
            "write the energy in the new variables, or equations in place of it", place_of(node->source)});
}

// One of [change]: known by its equations and values only.
Variable SystemReader::replaced_variable(const TomlEntry& entry) {
    if (system_.variable(entry.key) != nullptr)
        bad_input({"[change] gives old variables by new ones, and only the new ones are declared",
                   in_quotes(entry.key) + " is declared under [variables]",
                   "write it the other way round, or leave the old variable out of [variables]",
                   entry.place});
    claim_name(entry, "a replaced variable");
    Variable variable;
    variable.name = entry.key;
    variable.place = entry.place;
    return variable;
}

// The variables that [equations] are written in: those that [change] replaces stand where the new ones do.
std::vector<Variable> SystemReader::variables_before(const std::vector<std::string>& fresh) {
    const TomlNode& change = *root_.find("change");
    check_table(change);
    std::vector<Variable> replaced, before;
    std::vector<std::string> names;
    for (const TomlEntry& entry : change.entries) {
        replaced.push_back(replaced_variable(entry));
        names.push_back(entry.key);
    }
    if (fresh.size() != replaced.size() || fresh.empty())
        bad_input(
            {"[change] has one new variable for each one that it replaces: those of [variables] without "
             "an equation are new",
             "new: " + names_of(fresh) + "; replaced: " + names_of(names),
             "write an equation for each variable that stays, and none for new ones",
             place_of(change.source)});
    std::size_t used = 0;
    for (const Variable& v : system_.variables) {
        const bool is_new = std::find(fresh.begin(), fresh.end(), v.name) != fresh.end();
        before.push_back(is_new ? replaced[used++] : v);
    }
    return before;
}

// What stays has the symbols that it has in the equations; every variable has as many as the longest there.
void SystemReader::take_symbols(const std::vector<Variable>& before) {
    std::size_t most = 0;
    for (const Variable& v : before) most = std::max(most, v.jet.size());
    for (std::size_t v = 0; v < system_.variables.size(); ++v) {
        Variable& variable = system_.variables[v];
        if (before[v].name == variable.name) variable.jet = before[v].jet;
        while (variable.jet.size() < most)
            variable.jet.emplace_back(variable.name + std::string(variable.jet.size(), '\''));
        variable.weight = cln::zerop(weights_[v]) ? 0 : 1;
    }
}

ChangeOfEquations SystemReader::change_from(System before) const {
    ChangeOfEquations change{std::move(before), system_, {}, {{system_.eps, 0}}};
    for (const auto& small : small_) change.small[small.first] = 0;
    Scope scope = system_.constants();
    for (const NamedFunction& f : system_.functions) scope.define_function(f.name);
    for (const Variable& v : system_.variables) scope.define(v.name, v.jet.front());
    for (const TomlEntry& entry : root_.find("change")->entries) {
        const Variable* variable = change.before.variable(entry.key);
        change.replacements.push_back(
            {static_cast<std::size_t>(variable - change.before.variables.data()),
             {expression_of(entry.value, scope), entry.value.text, entry.value.source}});
    }
    return change;
}

void SystemReader::change_equations() {
    std::vector<std::string> fresh;
    if (const TomlNode* equations = root_.find("equations"))
        for (const Variable& v : system_.variables)
            if (equations->find(v.name) == nullptr) fresh.push_back(v.name);
    std::vector<Variable> after = system_.variables;
    system_.variables = variables_before(fresh);
    read_equation_texts();
    set_orders();
    read_equations();
    System before = std::move(system_);
    system_ = before;
    system_.variables = std::move(after);
    system_.equations.clear();
    take_symbols(before.variables);
    read_domain(); // for the time of the change, as the symbols are
    const ChangeOfEquations change = change_from(std::move(before));
    system_.equations = changed_equations(change);
    system_.positive.clear();
    for (Variable& variable : system_.variables) variable.jet.clear();
    derivation_ = std::make_shared<Derivation>();
    for (const Equation& equation : change.before.equations)
        derivation_->before.push_back({equation.variable, equation.text});
    for (const Replacement& r : change.replacements)
        derivation_->change.push_back({change.before.variables[r.variable].name, r.value.text});
}

} // namespace resonform
