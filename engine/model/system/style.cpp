// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/system/style.hpp"

namespace resonform {

const char* to_string(Style style) {
    switch (style) {
    case Style::poincare: return "poincare";
    case Style::inner_product: return "inner_product";
    case Style::hamiltonian: break;
    }
    return "hamiltonian";
}

std::optional<Style> style_of(const std::string& name) {
    for (const Style style : {Style::poincare, Style::inner_product, Style::hamiltonian})
        if (name == to_string(style)) return style;
    return std::nullopt;
}

const std::vector<std::string>& style_names() {
    static const std::vector<std::string> names{to_string(Style::poincare), to_string(Style::inner_product),
                                                to_string(Style::hamiltonian)};
    return names;
}

} // namespace resonform
