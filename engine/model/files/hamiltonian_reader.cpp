// SPDX-License-Identifier: GPL-3.0-or-later
// [hamiltonian] of a system.toml: canonical pairs, the energy, and the equations that follow from it.
//
//   energy = "p^2/2 + 1 - cos(q)"
//   momenta = { q = "p" }              q' = p,  p' = -sin(q)
#include "algebra/number/error.hpp"
#include "model/files/system_reader.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/expression.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"
#include "model/text/zero_test.hpp"

#include <algorithm>

namespace resonform {

bool SystemReader::is_canonical(const Variable& variable) const {
    return system_.hamiltonian &&
           system_.hamiltonian->has(static_cast<std::size_t>(&variable - system_.variables.data()));
}

std::size_t SystemReader::canonical_variable(const std::string& name, const TomlNode& node,
                                             const Place& place) const {
    const auto complain = [&](const std::string& rule, const std::string& value, const std::string& hint) {
        bad_input({rule, value, hint, place});
    };
    const Variable* variable = system_.variable(name);
    if (variable == nullptr)
        complain("a coordinate or momentum is not a declared variable", in_quotes(name),
                 suggest(name, variable_names()));
    if (variable->role != Role::fast)
        complain("a coordinate or momentum is not a fast variable",
                 in_quotes(name) + " is " + to_string(variable->role),
                 "give it role = \"fast\", or leave it out of " + node.source.key +
                     " and write its equation under [equations]");
    if (is_canonical(*variable))
        complain("the variable belongs to two canonical pairs", in_quotes(name), "correct one of the pairs");
    return static_cast<std::size_t>(variable - system_.variables.data());
}

void SystemReader::read_pairs() {
    const TomlNode* node = root_.find("hamiltonian");
    if (node == nullptr) return;
    check_keys(*node, {"energy", "momenta"});
    const TomlNode* energy = node->find("energy");
    if (energy == nullptr)
        bad_input({"the Hamiltonian system has no energy", "[hamiltonian]",
                   "write energy = \"p^2/2 + ...\" under [hamiltonian]", place_of(node->source)});
    const TomlNode* momenta = node->find("momenta");
    if (momenta != nullptr) check_table(*momenta);
    if (momenta == nullptr || momenta->entries.empty())
        bad_input({"the Hamiltonian system has no canonical pairs", "no pairs",
                   "write momenta = { x = \"p\" } under [hamiltonian]",
                   place_of(momenta == nullptr ? node->source : momenta->source)});
    system_.hamiltonian = Hamiltonian{0, string_of(*energy), energy->source, {}};
    for (const TomlEntry& entry : momenta->entries) {
        const std::size_t coordinate = canonical_variable(entry.key, *momenta, entry.place);
        const std::size_t momentum =
            canonical_variable(string_of(entry.value), *momenta, place_of(entry.value.source));
        if (coordinate == momentum)
            bad_value(entry.value, "the coordinate is given as its own momentum",
                      "name another variable, or declare one");
        system_.hamiltonian->pairs.emplace_back(coordinate, momentum);
    }
}

void SystemReader::read_energy() {
    if (!system_.hamiltonian) return;
    Hamiltonian& hamiltonian = *system_.hamiltonian;
    Scope scope = system_.constants();
    system_.define_functions(scope);
    for (const Variable& v : system_.variables) scope.define(v.name, v.jet.front());
    hamiltonian.energy = read_expression(hamiltonian.text, scope, hamiltonian.source);

    GiNaC::exmap rates;
    std::vector<Equation*> given;
    const auto derive = [&](std::size_t of, std::size_t by, const GiNaC::numeric& sign) {
        const Variable& variable = system_.variables[of];
        const GiNaC::ex slope = hamiltonian.energy.diff(system_.variables[by].jet.front());
        if (vanishes(slope) == Zero::yes)
            bad_input({"the energy does not depend on every coordinate and every momentum",
                       "it does not depend on " + system_.variables[by].name,
                       "a constant momentum is a parameter: leave the pair out, and write the equation of "
                       "the coordinate under [equations]",
                       place_of(hamiltonian.source)});
        const GiNaC::ex rate = sign * slope;
        rates[variable.jet.back()] = rate;
        Equation& equation = system_.equations[of];
        if (!equation.text.empty()) return given.push_back(&equation);
        equation.text = variable.jet.back().get_name() + " = " + spell(rate);
        equation.residual = variable.jet.back() - rate;
        equation.source.verbatim = false; // the text stands in no file
    };
    for (const auto& [coordinate, momentum] : hamiltonian.pairs) {
        derive(coordinate, momentum, 1);
        derive(momentum, coordinate, -1);
    }
    for (const Equation* equation : given) check_canonical(*equation, rates);
}

void SystemReader::check_canonical(const Equation& equation, const GiNaC::exmap& rates) const {
    const GiNaC::ex rest = equation.residual.subs(rates, GiNaC::subs_options::no_pattern);
    const Zero zero = vanishes(rest);
    if (zero == Zero::yes) return;
    const std::string value = "lhs - rhs becomes " + excerpt(spell(rest.expand()));
    if (zero == Zero::no)
        bad_input({"the equation of a canonical variable is the one that the energy gives", value,
                   "leave the equation out, or correct it or the energy", place_of(equation.source)});
    refuse(Reason::undecided,
           {"the equation of a canonical variable is seen to be the one that the energy gives", value,
            "leave the equation out", place_of(equation.source)});
}

} // namespace resonform
