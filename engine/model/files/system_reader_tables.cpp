// SPDX-License-Identifier: GPL-3.0-or-later
// Further tables of a system.toml: domain, relations, normal form, notation.
#include "algebra/number/error.hpp"
#include "model/files/system_reader.hpp"
#include "model/files/unit_check.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/system/names.hpp"
#include "model/system/style.hpp"
#include "model/system/system_file.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/eps_powers.hpp"
#include "model/text/expression.hpp"
#include "model/text/nearest.hpp"
#include "model/text/regular.hpp"
#include "model/text/toml_values.hpp"
#include "model/text/zero_test.hpp"

#include <algorithm>

namespace resonform {

namespace {

constexpr std::size_t most_declarations = 64;

// "amplitude.psi" -> kind and variable, which must fit together.
Notation notation_of(const TomlEntry& entry, const System& system) {
    const std::string value = string_of(entry.value);
    const std::size_t dot = value.find('.');
    Notation notation{entry.key, value.substr(0, dot), dot == std::string::npos ? "" : value.substr(dot + 1)};
    std::vector<std::string> known;
    for (const Variable& variable : system.variables) {
        for (const std::string& kind : constant_kinds(variable.role))
            known.push_back(kind + "." + variable.name);
    }
    if (std::find(known.begin(), known.end(), value) == known.end()) {
        bad_value(
            entry.value,
            "a notation names amplitude or phase of a fast variable or the constant of a drift variable",
            suggest(value, known));
    }
    return notation;
}

} // namespace

void SystemReader::read_domain() {
    const TomlNode* domain = root_.find("domain");
    if (domain == nullptr) return;
    check_keys(*domain, {"positive"});
    const TomlNode* positive = domain->find("positive");
    if (positive == nullptr) return;
    if (positive->type != TomlNode::Type::array) {
        bad_value(*positive, "'domain.positive' is an array of expressions",
                  "write positive = [\"1 + tau\"]");
    }
    if (positive->items.size() > most_declarations) {
        bad_value(*positive,
                  "'domain.positive' has at most " + std::to_string(most_declarations) + " expressions",
                  "declare names positive, or describe a smaller system");
    }
    Scope scope;
    for (const Parameter& p : system_.parameters) scope.define(p.name, p.symbol);
    system_.define_functions(scope);
    for (const Variable& v : system_.variables) {
        if (v.role == Role::slow) scope.define(v.name, v.jet.front());
    }
    for (const TomlNode& item : positive->items) {
        const GiNaC::ex value = read_expression(string_of(item), scope, item.source);
        if (vanishes(value) == Zero::yes || provably_positive(-value, system_)) {
            bad_value(item, "an expression declared positive can be positive", "correct or remove it");
        }
        system_.positive.push_back({value, item.text, item.source});
    }
    // A name by itself is the same as positive = true. So are consequences: k > 0 follows from k - 2, and
    // nonzero tau from tau^2 - k.
    const auto conclude = [this](auto& named, const GiNaC::ex& symbol) {
        named.positive = named.positive || provably_positive(symbol, system_);
        named.nonzero = named.nonzero || provably_nonzero(symbol, system_);
    };
    for (Parameter& p : system_.parameters) conclude(p, p.symbol);
    for (Variable& v : system_.variables)
        if (v.role == Role::slow) conclude(v, v.jet.front());
}

std::vector<GivenRelation> SystemReader::relation_values() const {
    const TomlNode* relations = root_.find("relations");
    if (relations == nullptr) return {};
    check_table(*relations);
    std::vector<std::string> names;
    Scope scope;
    for (const Parameter& p : system_.parameters) {
        names.push_back(p.name);
        if (relations->find(p.name) == nullptr)
            scope.define(p.name, p.symbol);
        else
            scope.withhold(p.name, "a relation reads a parameter that [relations] gives",
                           "write " + in_quotes(p.name) + " by the parameters that none gives");
    }
    scope.define("eps", system_.eps);
    std::vector<GivenRelation> values;
    for (const TomlEntry& entry : relations->entries) {
        const Parameter* parameter = system_.parameter(entry.key);
        if (parameter == nullptr)
            bad_input(Reason::name, {"the relation does not give a parameter by others", in_quotes(entry.key),
                                     suggest(entry.key, names), entry.place});
        const std::string text = string_of(entry.value);
        values.push_back(
            {parameter, {read_expression(text, scope, entry.value.source), text, entry.value.source}});
    }
    return values;
}

// omega_2 = "2*omega_1 + eps*sigma": an exact resonance at eps = 0 with its detuning.
void SystemReader::read_relations() {
    GiNaC::exmap values;
    for (const auto& [parameter, value] : relation_values()) {
        const TomlNode& node = *root_.find("relations")->find(parameter->name);
        if (std::any_of(small_.begin(), small_.end(), [&, given = parameter](const auto& small) {
                return small.first.is_equal(given->symbol);
            }))
            bad_value(node, "a parameter computed by [relations] is given a weight of its own",
                      "remove weight where it is declared, and write its power of eps here");
        const GiNaC::ex rest = regular_at_rest(value.value, node);
        if ((parameter->positive && !provably_positive(rest, system_)) ||
            (parameter->nonzero && !provably_nonzero(rest, system_)))
            bad_value(node, "a relation keeps at eps = 0 what is declared of " + in_quotes(parameter->name),
                      "declare what its value is made of positive");
        values.emplace(parameter->symbol, value.value);
        system_.relations.push_back({parameter->name, value.text, value.source});
    }
    if (values.empty()) return;
    const auto put = [&](GiNaC::ex& e) { e = e.subs(values, GiNaC::subs_options::no_pattern); };
    for (Equation& equation : system_.equations) put(equation.residual);
    if (system_.hamiltonian) put(system_.hamiltonian->energy);
    for (Declaration& declaration : system_.positive)
        declaration.value =
            declaration.value.subs(values, GiNaC::subs_options::no_pattern).subs(system_.eps == 0);
    for (NamedFunction& f : system_.functions)
        if (f.value) put(f.value->value);
    for (GivenMode& mode : system_.modes) for_each_part(mode, put);
    for (Equilibrium& at : system_.equilibrium) {
        put(at.value);
        at.value = at_rest(at.value);
    }
    system_.parameters.erase(std::remove_if(system_.parameters.begin(), system_.parameters.end(),
                                            [&](const Parameter& p) { return values.count(p.symbol) != 0; }),
                             system_.parameters.end());
}

// The value where eps and all small parameters vanish.
GiNaC::ex SystemReader::at_rest(const GiNaC::ex& e) const {
    GiNaC::exmap zero{{system_.eps, 0}};
    for (const auto& small : small_) zero[small.first] = 0;
    return e.subs(zero, GiNaC::subs_options::no_pattern);
}

GiNaC::ex SystemReader::regular_at_rest(const GiNaC::ex& e, const TomlNode& value) const {
    const auto regular = where_regular([&] { return at_rest(e); });
    if (!regular) bad_value(value, "the relation has no value at eps = 0", "remove what is divided by eps");
    return *regular;
}

// d = { weight = 2 } is small: it stands for eps^2*d.
void SystemReader::scale_small_parameters() {
    GiNaC::exmap values;
    for (const auto& [symbol, weight] : small_) {
        values[symbol] = GiNaC::pow(system_.eps, GiNaC::numeric(cln::cl_N(weight))) * symbol;
        for (const Declaration& declaration : system_.positive)
            if (declaration.value.has(symbol) && !declaration.value.is_equal(symbol))
                bad_input({"what is declared positive holds at eps = 0, without small parameters",
                           in_quotes(declaration.text), "leave " + symbol.get_name() + " out",
                           place_of(declaration.source)});
    }
    for (Equation& equation : system_.equations)
        equation.residual = equation.residual.subs(values, GiNaC::subs_options::no_pattern);
    if (system_.hamiltonian)
        system_.hamiltonian->energy =
            system_.hamiltonian->energy.subs(values, GiNaC::subs_options::no_pattern);
    for (GivenMode& mode : system_.modes) for_each_part(mode, [&](GiNaC::ex& e) { e = at_rest(e); });
}

// Finds the largest unit 1/q of which all weights and all powers of eps are multiples.
void SystemReader::refine_weights() {
    EpsPowers powers(system_.eps);
    for (std::size_t v = 0; v < system_.variables.size(); ++v)
        powers.note(weights_[v], system_.variables[v].place);
    for (Equation& equation : system_.equations)
        equation.residual = powers.taken_out(equation.residual, place_of(equation.source));
    if (system_.hamiltonian)
        system_.hamiltonian->energy =
            powers.taken_out(system_.hamiltonian->energy, place_of(system_.hamiltonian->source));
    system_.eps_root = powers.root();
    for (std::size_t v = 0; v < system_.variables.size(); ++v)
        system_.variables[v].weight = cln::cl_I_to_int(cln::numerator(weights_[v] * system_.eps_root));
    if (system_.eps_root == 1) return;
    const GiNaC::symbol root = symbol_of_eps_root(system_.eps_root);
    for (Equation& equation : system_.equations) equation.residual = powers.held(equation.residual, root);
    if (system_.hamiltonian) system_.hamiltonian->energy = powers.held(system_.hamiltonian->energy, root);
    system_.eps = root;
}

void SystemReader::read_normal_form() {
    const TomlNode* node = root_.find("normal_form");
    if (node == nullptr) return;
    check_keys(*node, {"near", "style"});
    if (const TomlNode* style = node->find("style"); style != nullptr) {
        const std::string name = string_of(*style);
        const std::optional<Style> known = style_of(name);
        if (!known)
            bad_value(*style, "unknown style: the styles are poincare, inner_product and hamiltonian",
                      suggest(name, style_names()));
        system_.style = *known;
    }
    const TomlNode* near = node->find("near");
    if (near == nullptr) return;
    system_.near = number_of(*near);
    if (cln::minusp(system_.near) || system_.near >= 1)
        bad_value(*near, "0 <= near < 1: divisors up to this size are kept", "write for example near = 0.01");
}

void SystemReader::read_notation() {
    const TomlNode* notation = root_.find("notation");
    if (notation == nullptr) return;
    check_table(*notation);
    for (const TomlEntry& entry : notation->entries) {
        claim_name(entry, "a notation");
        const Notation read = notation_of(entry, system_);
        for (const Notation& earlier : system_.notation) {
            if (earlier.kind != read.kind || earlier.variable != read.variable) continue;
            bad_value(entry.value,
                      "a constant has one name: " + in_quotes(earlier.name) + " stands for it already",
                      "remove one of the two");
        }
        system_.notation.push_back(read);
    }
}

// Results are written with names made from those of the variables: nothing else may have them.
void SystemReader::check_names_of_results() const {
    std::map<std::string, std::string> made; // name -> its meaning in results
    for (const Variable& variable : system_.variables) {
        made[variable.name + "_0"] = variable.name + " at t = 0";
        for (const std::string& kind : constant_kinds(variable.role))
            made[kind + "_" + variable.name] = kind + "." + variable.name;
        if (variable.role == Role::drift) made["z_" + variable.name] = "the new variable of " + variable.name;
    }
    for (const Equilibrium& at : system_.equilibrium) {
        const std::string& name = system_.variables[at.variable].name;
        made[deviation_name(name)] = "the deviation of " + name + " from its equilibrium";
    }
    for (const char* key : {"parameters", "variables", "functions", "notation", "coordinates"}) {
        const TomlNode* node = root_.find(key);
        if (node == nullptr) continue;
        for (const TomlEntry& entry : node->entries) {
            const auto found = made.find(entry.key);
            if (found == made.end() || entry.value.text == found->second) continue;
            bad_input({"results call " + found->second + " " + found->first + ": nothing else has this name",
                       in_quotes(entry.key), "choose another name", entry.place});
        }
    }
}

} // namespace resonform
