// SPDX-License-Identifier: GPL-3.0-or-later
// The normal form as JSON: schema resonform.normal_form/1 of design 6.1.
#include "emit/display/normal_form_json.hpp"
#include "emit/derive/derive.hpp"
#include "emit/derive/hamiltonian.hpp"
#include "emit/display/json.hpp"
#include "emit/display/normal_form_parts.hpp"

#include <fmt/format.h>
#include <string>
#include <utility>

namespace resonform {

namespace {

// x, or x - (1) where it is measured from an equilibrium.
std::string measured(const GradedField& field, const State& state) {
    const Polynomial shift = field.shift(state.variable, state.derivative);
    return shift.empty() ? state.name
                         : fmt::format("({} - ({}))", state.name, json_expression(*field.ring, shift));
}

// psi - I*psi'/omega, or the sum of all fast states with their coefficients.
std::string definition(const GradedField& field, std::size_t k) {
    const Ring& ring = *field.ring;
    const Mode& mode = field.modes[k];
    if (mode.oscillator) {
        const std::string omega = frequency_name(field, k);
        const auto state = [&](int derivative) {
            return measured(field,
                            field.first_order->states[field.first_order->index(mode.variable, derivative)]);
        };
        return fmt::format("{} - I*{}/{}, {} = {}", state(0), state(1), omega, omega,
                           json_expression(ring, mode.omega));
    }
    std::string text;
    for (const auto& [state, coefficient] : components(field, k)) {
        const std::string value = json_expression(ring, coefficient);
        text += text.empty() ? "" : " + ";
        const std::string name = measured(field, *state);
        text += value == "1" ? name : fmt::format("({})*{}", value, name);
    }
    return text;
}

// A real mode is its own conjugate.
Json fast_json(const GradedField& field) {
    Json list = Json::array();
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const Mode& mode = field.modes[k];
        list.push_back({{"name", mode.name},
                        {"conjugate", mode.is_real() ? mode.name : mode.conjugate_name},
                        {"eigenvalue", json_expression(*field.ring, field.eigenvalue(mode))},
                        {"definition", definition(field, k)}});
    }
    return list;
}

Json terms_json(const GradedField& field, const std::vector<NamedSeries>& list) {
    Json terms = Json::array();
    for (const NamedSeries& series : list)
        append_json_terms(terms, *field.ring, series.variable, series.total, field.outer());
    return terms;
}

} // namespace

Json certificate_json(const Certificate& certificate) {
    Json json = {{"holds", certificate.holds},
                 {"through_weight", json_rational(certificate.through_weight)},
                 {"normal_form_scan", certificate.normal_form_scan},
                 {"route", certificate.route},
                 {"error_probability", json_number(certificate.error_probability)},
                 {"points", certificate.points},
                 {"primes", certificate.primes}};
    if (!certificate.holds) json["complaint"] = certificate.complaint;
    return json;
}

Json normal_form_document(const GradedField& field, int order, int truncation, Style style, Json normal_form,
                          Json map, const std::vector<DivisorRecord>& divisors,
                          const Certificate& certificate) {
    Json document = json_head("resonform.normal_form/1", field.system());
    if (!field.system().equilibrium.empty()) document["equilibrium"] = equilibrium_json(field.system());
    document["order"] = json_rational(field.system().weight(order));
    document["truncation"] = json_rational(field.system().weight(truncation));
    document["style"] = to_string(style);
    document["fast"] = fast_json(field);
    document["normal_form"] = std::move(normal_form); // update() would copy it
    document["map"] = std::move(map);
    document["divisors"] = divisors_json(field, divisors, order);
    document["certificate"] = certificate_json(certificate);
    return document;
}

Json normal_form_json(const Normalization& normalization, int order) {
    const NormalForm& normal_form = normalization.normal_form;
    const GradedField& field = *normal_form.field;
    Json document = normal_form_document(field, order, normal_form.through, normal_form.style,
                                         terms_json(field, rates_through(normal_form, order)),
                                         terms_json(field, map_through(normalization, order)),
                                         normalization.divisors, normalization.certificate);
    if (normal_form.hamiltonian) document["hamiltonian"] = hamiltonian_json(normal_form, order);
    return document;
}

} // namespace resonform
