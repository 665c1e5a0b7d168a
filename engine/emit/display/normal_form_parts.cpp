// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/normal_form_parts.hpp"

#include "emit/display/display.hpp"
#include "emit/display/free_name.hpp"

#include <fmt/format.h>

#include <cmath>

namespace resonform {

std::string frequency_name(const GradedField& field, std::size_t mode) {
    const std::string number = field.modes.size() == 1 ? "" : std::to_string(mode + 1);
    return free_name(field.system(), "omega" + number);
}

std::vector<std::pair<const State*, Polynomial>> components(const GradedField& field, std::size_t mode) {
    std::vector<std::pair<const State*, Polynomial>> list;
    const ModeShape& shape = field.basis.modes[mode];
    for (std::size_t s = 0; s < shape.row.size(); ++s) {
        if (shape.row[s].is_zero()) continue;
        const State& state = field.first_order->states[field.basis.states[s]];
        list.emplace_back(
            &state, field.coefficients->convert(shape.row[s],
                                                place_of(field.system().equations[state.variable].source)));
    }
    return list;
}

Polynomial shift_of_mode(const GradedField& field, std::size_t mode) {
    Polynomial sum;
    if (field.system().equilibrium.empty()) return sum;
    for (const auto& [state, coefficient] : components(field, mode))
        sum = sum + field.ring->multiply(coefficient, field.shift(state->variable, state->derivative));
    return sum;
}

Section equilibrium_section(const GradedField& field) {
    Section section{"equilibrium at eps = 0", {}};
    for (const Equilibrium& at : field.system().equilibrium)
        define(section, field.system().variables[at.variable].name,
               display(*field.ring, field.shift(at.variable, 0)));
    return section;
}

namespace {

// The same in the variables of the field, which are 0 at the equilibrium.
DisplaySum mode_about_equilibrium(const GradedField& field, std::size_t mode) {
    if (!field.modes[mode].oscillator) {
        DisplaySum sum;
        for (const auto& [state, coefficient] : components(field, mode)) {
            DisplayTerm term = factored(display(*field.ring, coefficient));
            term.tail.push_back(symbol_factor(state->name));
            sum.terms.push_back(std::move(term));
        }
        return sum;
    }
    const std::string& variable = field.system().variables[field.modes[mode].variable].name;
    DisplaySum rate = symbol_sum(variable + "'");
    DisplayTerm& term = rate.terms.front();
    term.coefficient = -1;
    term.imaginary = true;
    term.factors.push_back(symbol_factor(frequency_name(field, mode), -1));
    return symbol_sum(variable) + rate;
}

} // namespace

DisplaySum old_mode(const GradedField& field, std::size_t mode) {
    const Polynomial shift = shift_of_mode(field, mode);
    DisplaySum sum = mode_about_equilibrium(field, mode);
    return shift.empty() ? sum : std::move(sum) + display(*field.ring, -shift);
}

Side written(const Series& series, int through, const SeriesWriter& write, const Substitutes& substitutes) {
    Side result;
    for (int n = 0; n <= through; ++n) result.groups.push_back(write(series.part(n), substitutes));
    return result;
}

std::string certificate_remark(const Certificate& certificate) {
    if (certificate.through_weight == 0) return "certificate: not made";
    if (!certificate.holds) return "certificate: DOES NOT HOLD: " + certificate.complaint;
    if (!std::isfinite(certificate.error_probability))
        return fmt::format("certificate: holds through weight {} ({}; {} points, all residuals are small)",
                           to_string(certificate.through_weight), certificate.route, certificate.points);
    return fmt::format("certificate: holds through weight {} ({}; {} points, error probability {:.1e})",
                       to_string(certificate.through_weight), certificate.route, certificate.points,
                       certificate.error_probability);
}

Substitutes phases(const Ring& ring) {
    Substitutes substitutes;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (ring.generator(id).kind != GeneratorKind::phase) continue;
        DisplaySum argument = symbol_sum(ring.generator(id).name);
        argument.terms.front().imaginary = true;
        substitutes.emplace(id, function_factor("exp", std::move(argument)));
    }
    return substitutes;
}

std::string normal_form_title(const NormalForm& normal_form, int order) {
    const System& system = normal_form.field->system();
    return fmt::format("normal form of {} through weight {} (style {})", system.name_with_settings(),
                       to_string(system.weight(order)), to_string(normal_form.style));
}

namespace {

template <class Of>
std::vector<NamedSeries> through(const GradedField& field, const Of& of, bool is_map, int order) {
    std::vector<NamedSeries> list;
    visit_variables(field, of, is_map, [&](const std::string& name, const Series& series) {
        list.push_back({name, series.total(order)});
    });
    return list;
}

} // namespace

std::vector<NamedSeries> rates_through(const NormalForm& normal_form, int order) {
    return through(*normal_form.field, normal_form, false, order);
}

std::vector<NamedSeries> map_through(const Normalization& normalization, int order) {
    return through(*normalization.normal_form.field, normalization.map, true, order);
}

} // namespace resonform
