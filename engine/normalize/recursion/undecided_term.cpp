// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/undecided_term.hpp"

namespace resonform {

namespace {

std::optional<UndecidedTerm> undecided_in(const GradedField& field, const std::string& rate,
                                          const Series& series, int through) {
    for (int weight = 0; weight <= through; ++weight)
        for (const auto& [monomial, coefficient] : field.ring->collect(series.part(weight), field.outer()))
            if (field.ring->is_zero(coefficient) == Zero::unknown)
                return UndecidedTerm{rate, monomial, coefficient};
    return std::nullopt;
}

} // namespace

std::optional<UndecidedTerm> undecided_term(const NormalForm& form) {
    const GradedField& field = *form.field;
    if (field.ring->is_canonical()) return std::nullopt;
    std::optional<UndecidedTerm> found;
    const auto look = [&](const auto& variables, const std::vector<Series>& rates) {
        for (std::size_t k = 0; k < rates.size() && !found; ++k)
            found = undecided_in(field, variables[k].name + "'", rates[k], form.through);
    };
    look(field.modes, form.mode);
    look(field.slow, form.slow);
    look(field.angles, form.angle);
    look(field.drift, form.drift);
    return found;
}

} // namespace resonform
