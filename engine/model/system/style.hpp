// SPDX-License-Identifier: GPL-3.0-or-later
// The style of a normal form, which selects one of the possible ones (docs/design/12_styles.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace resonform {

enum class Style { poincare, inner_product, hamiltonian };

const char* to_string(Style style);
// nullopt: no style has this name.
std::optional<Style> style_of(const std::string& name);
const std::vector<std::string>& style_names();

} // namespace resonform
