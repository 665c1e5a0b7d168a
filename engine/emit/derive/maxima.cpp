// SPDX-License-Identifier: GPL-3.0-or-later
// A normal form as a Maxima script: rate[z1], old_minus_new[z1] and so on.
#include "emit/derive/derive.hpp"
#include "emit/display/display.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/spelling.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

std::string maxima_name(const std::string& name) { return maxima_spelling().symbol(name, 0); }

std::string assumption(const std::string& name, bool positive, bool nonzero) {
    if (positive) return fmt::format("assume({} > 0)$\n", maxima_name(name));
    return nonzero ? fmt::format("assume(notequal({}, 0))$\n", maxima_name(name)) : std::string();
}

std::string assumptions(const GradedField& field) {
    std::string text = assumption("eps", true, true);
    for (const Parameter& p : field.system().parameters) text += assumption(p.name, p.positive, p.nonzero);
    for (const SlowVariable& slow : field.slow) {
        const Variable& variable = field.system().variables[slow.variable];
        text += assumption(slow.name, variable.positive, variable.nonzero);
    }
    return text;
}

std::string assignments(const GradedField& field, const std::string& array,
                        const std::vector<NamedSeries>& list) {
    std::string text;
    for (const NamedSeries& series : list)
        text += fmt::format(
            "{}[{}] : {}$\n", array, maxima_name(series.variable),
            spell(display_collected(*field.ring, series.total, field.outer(), phases(*field.ring)),
                  maxima_spelling()));
    return text;
}

} // namespace

std::string normal_form_maxima(const Normalization& normalization, int order) {
    const NormalForm& normal_form = normalization.normal_form;
    const GradedField& field = *normal_form.field;
    return fmt::format("/* {} */\n{}\n{}\n/* as a function of the new variables */\n{}",
                       normal_form_title(normal_form, order), assumptions(field),
                       assignments(field, "rate", rates_through(normal_form, order)),
                       assignments(field, "old_minus_new", map_through(normalization, order)));
}

} // namespace resonform
