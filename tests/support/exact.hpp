// SPDX-License-Identifier: GPL-3.0-or-later
// Exact comparison with printed formulas: a coefficient is written as in a system file and read into
// the ring of the field under test.
#pragma once

#include "expand/expansion/graded_field.hpp"
#include "model/files/read_system.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace resonform::test {

inline std::filesystem::path source_dir() { return RESONFORM_SOURCE_DIR; }

inline std::shared_ptr<const FirstOrderSystem> first_order_of(System system) {
    return std::make_shared<const FirstOrderSystem>(
        solve_for_highest(std::make_shared<const System>(std::move(system))));
}

// systems/<name>/system.toml
inline std::shared_ptr<const FirstOrderSystem> first_order_named(const std::string& name) {
    return first_order_of(read_system(source_dir() / "systems" / name / "system.toml"));
}

inline std::shared_ptr<const FirstOrderSystem> first_order_from(const std::string& toml) {
    return first_order_of(read_system_text(toml, "test/system.toml"));
}

inline std::shared_ptr<const GradedField> field_named(const std::string& name) {
    return std::make_shared<const GradedField>(expand(first_order_named(name)));
}

inline std::shared_ptr<const GradedField> field_from(const std::string& toml) {
    return std::make_shared<const GradedField>(expand(first_order_from(toml)));
}

// A coefficient in parameters, slow variables and eps.
inline Polynomial coefficient(const CoefficientRing& coefficients, const System& system,
                              const std::string& text) {
    Scope scope;
    for (const auto& p : system.parameters) scope.define(p.name, p.symbol);
    for (const auto& v : system.variables)
        if (v.role == Role::slow) scope.define(v.name, v.jet.front());
    scope.define("eps", system.eps);
    const SourceText source{{"test", 1, 1, "expected", text}};
    return coefficients.convert(read_expression(text, scope, source), {});
}

// times_i: the coefficient times the imaginary unit.
inline Polynomial coefficient(const GradedField& field, const std::string& text, bool times_i = false) {
    const Polynomial value = coefficient(*field.coefficients, field.system(), text);
    return times_i ? field.ring->multiply(field.ring->imaginary(), value) : value;
}

// The product of generators of a field: {{"z1", 2}, {"eps", 1}}.
inline Polynomial monomial(const Ring& ring, const std::vector<std::pair<std::string, int>>& powers) {
    Polynomial result = ring.one();
    for (const auto& [name, power] : powers)
        result = ring.multiply(result, ring.gen(ring.find(name).value(), power));
    return result;
}

} // namespace resonform::test
