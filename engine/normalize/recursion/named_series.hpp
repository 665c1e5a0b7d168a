// SPDX-License-Identifier: GPL-3.0-or-later
// Every series of a normalization by its name, for what goes through all of its coefficients.
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <string>
#include <vector>

namespace resonform {

struct SeriesOfForm {
    std::string name; // "normal form, mode 0"; "map, drift 1"
    Series* series;
};

// Of the normal form, then of the map; in the style hamiltonian also the energy and the generator.
std::vector<SeriesOfForm> all_series(Normalization& n);

} // namespace resonform
