// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/json.hpp"

#include "emit/display/as_written.hpp"
#include "emit/display/display.hpp"
#include "emit/display/spelling.hpp"
#include "model/text/canonical.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

bool is_list_of_objects(const Json& value) {
    return value.is_array() && !value.empty() &&
           std::all_of(value.begin(), value.end(), [](const Json& element) { return element.is_object(); });
}

std::string member(const Json& value) {
    if (!is_list_of_objects(value)) return value.dump();
    std::string text = "[";
    for (std::size_t i = 0; i < value.size(); ++i) text += (i == 0 ? "\n    " : ",\n    ") + value[i].dump();
    return text + "\n  ]";
}

} // namespace

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (double value : values) list.push_back(json_number(value));
    return list;
}

Json json_rational(const Rational& value) {
    if (cln::denominator(value) != 1) return to_string(value);
    return cln::cl_I_to_int(cln::numerator(value));
}

std::string json_document(const Json& value) {
    if (!value.is_object()) return value.dump() + "\n";
    std::string text = "{";
    for (auto it = value.begin(); it != value.end(); ++it)
        text += (it == value.begin() ? "\n  " : ",\n  ") + Json(it.key()).dump() + ": " + member(it.value());
    return text + "\n}\n";
}

Json json_head(const std::string& schema, const System& system) {
    Json head = {{"schema", schema}, {"system", system.name}};
    for (const Setting& setting : system.settings) head["set"][setting.parameter] = setting.value;
    if (system.digits > 0) head["digits"] = system.digits;
    return head;
}

Json equilibrium_json(const System& system) {
    Json values = Json::object();
    for (const Equilibrium& at : system.equilibrium) {
        const std::string& name = system.variables[at.variable].name;
        Equation equation{name, name + " = " + spell(at.value), 0, at.source};
        equation.source.verbatim = false; // the text stands in no file
        values[name] = spell(as_written(equation).right, json_spelling());
    }
    return values;
}

std::string json_expression(const Ring& ring, const Polynomial& p) {
    return spell(display(ring, p), json_spelling());
}

Json json_exponents(const Ring& ring, const Monomial& monomial, const std::vector<GeneratorId>& outer) {
    Json exponents = Json::object();
    for (GeneratorId id : outer)
        if (const Rational exponent = ring.exponent_of_named(monomial, id); !cln::zerop(exponent))
            exponents[ring.generator(id).name] = json_rational(exponent);
    return exponents;
}

Json json_weight(const Ring& ring, const Monomial& monomial) {
    return json_rational(Rational(ring.weight(monomial)) / ring.weights_in_one());
}

void append_json_terms(Json& list, const Ring& ring, const std::string& variable, const Polynomial& p,
                       const std::vector<GeneratorId>& outer) {
    for (const auto& [monomial, coefficient] : collect_in_order(ring, p, outer)) {
        list.push_back({{"variable", variable},
                        {"exponents", json_exponents(ring, monomial, outer)},
                        {"weight", json_weight(ring, monomial)},
                        {"coefficient", json_expression(ring, coefficient)}});
    }
}

} // namespace resonform
