// SPDX-License-Identifier: GPL-3.0-or-later
// Helpers of all printers of a normal form: its variables in order, its terms through a weight.
#pragma once

#include "emit/display/page.hpp"
#include "emit/display/slow_rate.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <string>
#include <utility>
#include <vector>

namespace resonform {

// "omega", or "omega1", "omega2", ... with several oscillators; another name when the system uses it.
std::string frequency_name(const GradedField& field, std::size_t mode);

// z = sum of coefficient * state: the fast states that take part in the definition of a mode.
std::vector<std::pair<const State*, Polynomial>> components(const GradedField& field, std::size_t mode);

// What the definition of a mode subtracts, where its states are measured from an equilibrium.
Polynomial shift_of_mode(const GradedField& field, std::size_t mode);

// "equilibrium at eps = 0": c = s/(s + kappa); without formulas if there is none.
Section equilibrium_section(const GradedField& field);

// The definition of a mode: psi - I*psi'/omega, or the sum of all states that take part, in the user's
// variables.
DisplaySum old_mode(const GradedField& field, std::size_t mode);

// The parts of a series as groups, one for each weight.
Side written(const Series& series, int through, const SeriesWriter& write, const Substitutes& substitutes);

// "certificate: holds through weight 3 (...)"
std::string certificate_remark(const Certificate& certificate);

// A harmonic e^{i k phi} is shown as exp(k*I*phi).
Substitutes phases(const Ring& ring);

// "normal form of ... through weight 3 (style poincare)"
std::string normal_form_title(const NormalForm& normal_form, int order);

// visit(name, series) of each angle, slow and drift variable, in this order; of a map: of slow variables only
// those that are driven. `of`: rates or a map, in whatever coefficients.
template <class Of, class Visit>
void visit_others(const GradedField& field, const Of& of, bool is_map, const Visit& visit) {
    for (std::size_t k = 0; k < field.angles.size(); ++k) visit(field.angles[k].name, of.angle[k]);
    for (std::size_t k = 0; k < field.slow.size(); ++k)
        if (!is_map || field.slow[k].driven) visit(field.slow[k].name, of.slow[k]);
    for (std::size_t k = 0; k < field.drift.size(); ++k) visit(field.drift[k].name, of.drift[k]);
}
// The same, of the modes first.
template <class Of, class Visit>
void visit_variables(const GradedField& field, const Of& of, bool is_map, const Visit& visit) {
    for (std::size_t k = 0; k < field.modes.size(); ++k) visit(field.modes[k].name, of.mode[k]);
    visit_others(field, of, is_map, visit);
}

// A variable of the normal form with its rate, or of the map with old minus new: the sum of all weights
// through `order`.
struct NamedSeries {
    std::string variable;
    Polynomial total;
};
std::vector<NamedSeries> rates_through(const NormalForm& normal_form, int order);
std::vector<NamedSeries> map_through(const Normalization& normalization, int order);

} // namespace resonform
