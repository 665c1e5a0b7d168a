// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/normal_form_parts.hpp"

#include "emit/drift_frame.hpp"

#include <fmt/format.h>

namespace resonform {

std::vector<GeneratorId> modes_and_eps(const GradedField& field) {
    std::vector<GeneratorId> outer;
    for (const Mode& mode : field.modes) outer.insert(outer.end(), {mode.z, mode.zbar});
    outer.push_back(field.eps);
    return outer;
}

std::string frequency_name(const GradedField& field, std::size_t mode) {
    const std::string number = field.modes.size() == 1 ? "" : std::to_string(mode + 1);
    return free_name(field.system(), "omega" + number);
}

std::string normal_form_title(const NormalForm& normal_form, int order) {
    return fmt::format("normal form of {} through weight {} (style {})",
                       normal_form.field->system().name_with_settings(), order, normal_form.style);
}

std::vector<NamedSeries> rates_through(const NormalForm& normal_form, int order) {
    const GradedField& field = *normal_form.field;
    std::vector<NamedSeries> list;
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        list.push_back({field.modes[k].name, normal_form.mode[k].total(order)});
    for (std::size_t k = 0; k < field.slow.size(); ++k)
        list.push_back({field.slow[k].name, normal_form.slow[k].total(order)});
    for (std::size_t k = 0; k < field.drift.size(); ++k)
        list.push_back({field.drift[k].name, normal_form.drift[k].total(order)});
    return list;
}

std::vector<NamedSeries> map_through(const Normalization& normalization, int order) {
    const GradedField& field = *normalization.normal_form.field;
    std::vector<NamedSeries> list;
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        list.push_back({field.modes[k].name, normalization.map.mode[k].total(order)});
    for (std::size_t k = 0; k < field.drift.size(); ++k)
        list.push_back({field.drift[k].name, normalization.map.drift[k].total(order)});
    return list;
}

} // namespace resonform
