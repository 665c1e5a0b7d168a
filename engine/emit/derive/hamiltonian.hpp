// SPDX-License-Identifier: GPL-3.0-or-later
// Additional output for a normal form of style hamiltonian (precondition).
#pragma once

#include "emit/display/json.hpp"
#include "emit/display/page.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <vector>

namespace resonform {

// The energy in actions and resonant parts, and their definitions.
std::vector<Section> hamiltonian_sections(const NormalForm& normal_form, int order);

// { "brackets", "actions", "energy", "invariants", "generator" } (docs/file_formats.md)
Json hamiltonian_json(const NormalForm& normal_form, int order);

} // namespace resonform
