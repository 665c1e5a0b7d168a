// SPDX-License-Identifier: GPL-3.0-or-later
// [equilibrium]: where fast variables rest at eps = 0, if not at 0.
#include "algebra/number/error.hpp"
#include "model/exact/equilibrium.hpp"
#include "model/files/system_reader.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"

#include <algorithm>

namespace resonform {

namespace {

// A name in the value that the frozen equations do not hold as a constant. `small` are parameters.
void check_symbols(const TomlNode& node, const GiNaC::ex& value, const System& system,
                   const std::vector<std::pair<GiNaC::symbol, Rational>>& small) {
    if (value.has(system.eps))
        bad_value(node, "an equilibrium is one of the equations at eps = 0, and does not hold eps",
                  "leave eps out: how the motion leaves this place with eps is found, and is in the map");
    for (const Variable& v : system.variables)
        if (v.role != Role::slow && value.has(v.jet.front()))
            bad_value(node,
                      "an equilibrium depends on slow variables and parameters only: " + in_quotes(v.name) +
                          " is " + to_string(v.role),
                      "put its own equilibrium in, or write \"solve\"");
    for (const auto& parameter : small)
        if (value.has(parameter.first))
            bad_value(node,
                      "an equilibrium is one of the equations at eps = 0, where " +
                          in_quotes(parameter.first.get_name()) + ", a parameter with a weight, is 0",
                      "leave it out");
}

} // namespace

void SystemReader::read_equilibrium() {
    const TomlNode* table = root_.find("equilibrium");
    if (table == nullptr) return;
    check_table(*table);
    std::vector<std::string> fast;
    Scope scope;
    scope.define("eps", system_.eps);
    for (const Parameter& p : system_.parameters) scope.define(p.name, p.symbol);
    system_.define_functions(scope);
    for (const Variable& v : system_.variables) {
        scope.define(v.name, v.jet.front());
        if (v.role == Role::fast) fast.push_back(v.name);
    }
    for (const TomlEntry& entry : table->entries) {
        const Variable* variable = system_.variable(entry.key);
        if (variable == nullptr)
            bad_input(Reason::name, {"[equilibrium] names no variable of the system", in_quotes(entry.key),
                                     suggest(entry.key, fast), entry.place});
        if (variable->role != Role::fast)
            bad_input({"an equilibrium is one of fast variables",
                       in_quotes(entry.key) + " is " + to_string(variable->role),
                       "leave it out: it stands still at eps = 0 wherever it is", entry.place});
        Equilibrium at{static_cast<std::size_t>(variable - system_.variables.data()), 0, false,
                       entry.value.source};
        at.wanted = entry.value.type == TomlNode::Type::string && string_of(entry.value) == "solve";
        if (!at.wanted) at.value = expression_of(entry.value, scope);
        check_symbols(entry.value, at.value, system_, small_);
        system_.equilibrium.push_back(std::move(at));
    }
}

void SystemReader::settle_equilibrium() {
    if (!system_.equilibrium.empty()) resonform::settle_equilibrium(system_);
}

} // namespace resonform
