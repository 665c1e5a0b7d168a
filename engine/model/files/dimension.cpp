// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/dimension.hpp"

#include "algebra/number/error.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/expression.hpp"
#include "model/text/lexer.hpp"
#include "model/text/toml_values.hpp"

#include <cln/rational.h>

namespace resonform {

namespace {

// Derived units of the SI.
const std::map<std::string, std::string>& derived_units() {
    static const std::map<std::string, std::string> units = {
        {"N", "kg*m/s^2"}, {"J", "kg*m^2/s^2"},   {"W", "kg*m^2/s^3"},     {"Pa", "kg/m/s^2"}, {"Hz", "1/s"},
        {"C", "A*s"},      {"V", "kg*m^2/s^3/A"}, {"F", "A^2*s^4/kg/m^2"}, {"rad", "1"}};
    return units;
}

using Units = std::map<std::string, GiNaC::symbol>; // of one text, by name

GiNaC::ex value_of(const std::string& text, const SourceText& source, Units& units) {
    Scope scope;
    for (const auto& [name, primes] : highest_primes(text, source)) {
        const auto derived = derived_units().find(name);
        scope.define(name, derived == derived_units().end()
                               ? GiNaC::ex(units.try_emplace(name, name).first->second)
                               : value_of(derived->second, source, units));
    }
    return read_expression(text, scope, source);
}

// Adds a factor; false: it is none.
bool take(Dimension& dimension, const GiNaC::ex& factor) {
    const bool raised = GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::rational);
    const GiNaC::ex base = raised ? factor.op(0) : factor;
    const Rational exponent = raised ? to_rational(factor.op(1)) : Rational(1);
    if (!GiNaC::is_a<GiNaC::symbol>(base)) return factor.is_equal(1);
    dimension = product(dimension, {{GiNaC::ex_to<GiNaC::symbol>(base).get_name(), exponent}});
    return true;
}

// An unknown unit is written as that of its symbol: [eps].
std::string factor_text(const std::string& base, const Rational& exponent) {
    std::string name = base.front() == '?' ? "[" + base.substr(1) + "]" : base;
    if (exponent == 1) return name;
    const std::string text = to_string(exponent);
    return name + "^" + (cln::denominator(exponent) == 1 ? text : "(" + text + ")");
}

} // namespace

Dimension product(const Dimension& a, const Dimension& b) {
    Dimension result = a;
    for (const auto& [name, exponent] : b) {
        const auto at = result.try_emplace(name, 0).first;
        at->second = at->second + exponent;
        if (cln::zerop(at->second)) result.erase(at);
    }
    return result;
}

Dimension power(const Dimension& a, const Rational& exponent) {
    Dimension result;
    if (cln::zerop(exponent)) return result;
    for (const auto& [name, n] : a) result[name] = n * exponent;
    return result;
}

Dimension quotient(const Dimension& a, const Dimension& b) { return product(a, power(b, -1)); }

std::string to_string(const Dimension& dimension) {
    std::string above, below;
    for (const auto& [name, exponent] : dimension) {
        const bool negative = cln::minusp(exponent);
        std::string& side = negative ? below : above;
        side += (negative ? "/" : side.empty() ? "" : "*") + factor_text(name, cln::abs(exponent));
    }
    return (above.empty() ? "1" : above) + below;
}

Dimension read_unit(const std::string& text, const SourceText& source) {
    Dimension dimension;
    if (text.empty()) return dimension;
    Units units;
    const GiNaC::ex value = value_of(text, source, units);
    bool good = true;
    if (GiNaC::is_a<GiNaC::mul>(value))
        for (const GiNaC::ex& factor : value) good = take(dimension, factor) && good;
    else
        good = take(dimension, value);
    if (!good)
        bad_input({"a unit is a product of powers of units", in_quotes(text),
                   "write it as in \"kg*m^2/s^2\"; \"1\" is none", place_of(source)});
    return dimension;
}

std::string unit_of(const TomlNode& table) {
    const TomlNode* node = table.find("unit");
    if (node == nullptr) return "";
    std::string unit = string_of(*node);
    read_unit(unit, node->source);
    return unit;
}

Dimension Dimensions::resolved(const Dimension& dimension) const {
    Dimension result;
    for (const auto& [name, exponent] : dimension) {
        const auto found = known_.find(name);
        const Dimension one{{name, 1}};
        result = product(result, power(found == known_.end() ? one : resolved(found->second), exponent));
    }
    return result;
}

bool Dimensions::equate(const Dimension& a, const Dimension& b) {
    const Dimension ratio = resolved(quotient(a, b));
    for (const auto& [name, exponent] : ratio) {
        if (name.front() != '?') continue;
        known_[name] = power(quotient(ratio, {{name, exponent}}), -1 / exponent);
        return true;
    }
    return ratio.empty();
}

} // namespace resonform
