// SPDX-License-Identifier: GPL-3.0-or-later
// What every printer of a normal form asks: its variables in order, its terms through a weight.
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

// The definition of a mode: psi - I*psi'/omega, or the sum of all states that take part.
DisplaySum old_mode(const GradedField& field, std::size_t mode);

// The parts of a series as groups, one for each weight.
Side written(const Series& series, int through, const SeriesWriter& write, const Substitutes& substitutes);

// "certificate: holds through weight 3 (...)"
std::string certificate_remark(const Certificate& certificate);

// A harmonic e^{i k phi} is shown as exp(k*I*phi).
Substitutes phases(const Ring& ring);

// "normal form of ... through weight 3 (style poincare)"
std::string normal_form_title(const NormalForm& normal_form, int order);

// A variable of the normal form with its rate, or of the map with old minus new: the sum of all weights
// through `order`.
struct NamedSeries {
    std::string variable;
    Polynomial total;
};
std::vector<NamedSeries> rates_through(const NormalForm& normal_form,
                                       int order); // modes, angles, slow, drift
std::vector<NamedSeries> map_through(const Normalization& normalization,
                                     int order); // the same; slow: those that are driven

} // namespace resonform
