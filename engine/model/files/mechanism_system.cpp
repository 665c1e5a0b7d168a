// SPDX-License-Identifier: GPL-3.0-or-later
// A system.toml with [coordinates]: its equations are derived, and read like those of every system.
#include "algebra/number/error.hpp"
#include "model/files/mechanism_reader.hpp"
#include "model/files/system_reader.hpp"
#include "model/files/unit_check.hpp"
#include "model/mechanics/equations_of.hpp"
#include "model/system/system_file.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/toml_values.hpp"

#include <algorithm>

namespace resonform {

namespace {

std::string in_place_of(const std::string& coordinate, const MechanicalEquations& derived) {
    for (const auto& former : derived.constants)
        if (former.instead_of == coordinate) return in_quotes(former.coordinate.name) + ", an integral";
    return "another";
}

// "units found: eps in 1/m, theta in 1"
std::string remark_on_units(const std::vector<std::pair<std::string, std::string>>& found) {
    std::string text;
    for (const auto& [name, unit] : found)
        text.append(text.empty() ? "units found: " : ", ").append(name).append(" in ").append(unit);
    return text;
}

} // namespace

bool SystemReader::is_mechanism() const { return root_.find("coordinates") != nullptr; }

void SystemReader::require_coordinates() const {
    if (is_mechanism()) return;
    for (const std::string& key : mechanism_tables())
        if (const TomlNode* node = root_.find(key); node != nullptr && key != "change")
            bad_input({"the mechanism has no table [coordinates]", "[" + key + "] without it",
                       "declare coordinates, as x = { unit = \"m\" }", place_of(node->source)});
}

void SystemReader::derive_equations() {
    for (const char* key : {"equations", "hamiltonian"})
        if (const TomlNode* node = root_.find(key))
            bad_input({"the equations of a mechanism are derived", "[" + std::string(key) + "]",
                       "remove this table, or [coordinates]", place_of(node->source)});
    for (const auto& [key, what] :
         {std::pair("coordinates", "a coordinate"), std::pair("integrals", "an integral"),
          std::pair("quasi_velocities", "a quasi-velocity")})
        if (const TomlNode* node = root_.find(key)) {
            check_table(*node);
            for (const TomlEntry& entry : node->entries)
                if (system_.variable(entry.key) == nullptr) claim_name(entry, what);
        }
    // Symbols, weights and domain for the time of the derivation; the equations bring their own.
    for (std::size_t v = 0; v < system_.variables.size(); ++v) {
        for (const char* primes : {"", "'", "''"})
            system_.variables[v].jet.emplace_back(system_.variables[v].name + primes);
        system_.variables[v].weight = cln::zerop(weights_[v]) ? 0 : 1;
    }
    read_domain();
    const Mechanism mechanism = MechanismReader(root_, system_).read();
    const std::string units = remark_on_units(check_units(mechanism, system_, relation_values()));
    MechanicalEquations derived = equations_of(mechanism, system_);
    system_.positive.clear();
    for (Variable& variable : system_.variables) variable.jet.clear();
    for (const auto& former : derived.constants) {
        take_constant(former.coordinate, former.role);
        if (former.fixed) make_parameter(former.coordinate.name);
    }
    for (const Variable& variable : system_.variables) {
        const auto line = std::find_if(derived.equations.begin(), derived.equations.end(),
                                       [&](const auto& l) { return l.variable == variable.name; });
        if (line == derived.equations.end())
            bad_input({"the variable does not belong to the motion of the mechanism",
                       in_quotes(variable.name) + " is replaced by " + in_place_of(variable.name, derived),
                       "leave it out of [variables]", variable.place});
        system_.equations.push_back({variable.name, line->text, 0, line->source});
    }
    for (const auto& line : derived.equations)
        if (system_.variable(line.variable) == nullptr)
            bad_input({"a coordinate that stays is not a variable", in_quotes(line.variable),
                       "declare " + line.variable + " under [variables], with its role",
                       place_of(root_.find("coordinates")->source)});
    check_roles();
    if (!units.empty()) derived.derivation.remarks.push_back(units);
    derivation_ = std::make_shared<Derivation>(std::move(derived.derivation));
}

// Makes a constant of the motion at eps = 0 slow or a drift by `role`, or checks its role in the file.
void SystemReader::take_constant(const Coordinate& constant, Role role) {
    const auto found = std::find_if(system_.variables.begin(), system_.variables.end(),
                                    [&](const Variable& v) { return v.name == constant.name; });
    if (found == system_.variables.end()) {
        Variable variable;
        variable.name = constant.name;
        variable.role = role;
        variable.place = constant.place;
        system_.variables.push_back(std::move(variable));
        weights_.push_back(0);
        return;
    }
    const auto undecided = std::find(undecided_.begin(), undecided_.end(), constant.name);
    if (undecided != undecided_.end()) {
        found->role = role;
        undecided_.erase(undecided);
        if (role == Role::drift && found->nonzero)
            bad_input({"a variable that is not slow is declared positive or nonzero",
                       in_quotes(found->name) + " is a drift", "remove the key", found->place});
    } else if (found->role != Role::slow && found->role != role) {
        bad_input({"what is constant at eps = 0 is slow where something depends on it, else a drift",
                   in_quotes(found->name) + " is " + to_string(found->role),
                   "write role = \"" + std::string(to_string(role)) + "\", or leave the role out",
                   found->place});
    }
}

// Turns a slow variable that is constant for every eps into a parameter.
void SystemReader::make_parameter(const std::string& name) {
    const auto found = std::find_if(system_.variables.begin(), system_.variables.end(),
                                    [&](const Variable& v) { return v.name == name; });
    system_.parameters.push_back(
        {name, found->positive, found->nonzero, found->unit, GiNaC::symbol(name), found->place});
    weights_.erase(weights_.begin() + (found - system_.variables.begin()));
    system_.variables.erase(found);
}

void SystemReader::check_roles() const {
    for (const std::string& name : undecided_)
        bad_input({"a variable that is not constant at eps = 0 has no role", in_quotes(name),
                   "write role = \"fast\", \"angle\" or \"slow\"", system_.variable(name)->place});
}

// Moves parameters that derived equations do not hold, as a mass that cancels, into System::cancelled.
void SystemReader::drop_cancelled() {
    if (!derivation_) return;
    const auto used = [&](const Parameter& p) {
        bool found = false;
        const auto look = [&](const GiNaC::ex& e) { found = found || e.has(p.symbol); };
        for (const Equation& equation : system_.equations) look(equation.residual);
        for (const Declaration& declaration : system_.positive) look(declaration.value);
        for (GivenMode& mode : system_.modes) for_each_part(mode, look);
        for (const Equilibrium& at : system_.equilibrium) look(at.value);
        return found;
    };
    std::vector<Parameter> kept;
    for (Parameter& p : system_.parameters)
        if (used(p))
            kept.push_back(std::move(p));
        else
            system_.cancelled.push_back(std::move(p));
    system_.parameters = std::move(kept);
    system_.derivation = derivation_;
}

} // namespace resonform
