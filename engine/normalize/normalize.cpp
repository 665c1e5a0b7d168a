// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/normalize.hpp"

#include "normalize/inner_product.hpp"

namespace resonform {

Normalization normalize(std::shared_ptr<const GradedField> field, int through,
                        const NormalizeOptions& options) {
    const Style style = field->system().style;
    switch (style) {
    case Style::poincare: return normalize_poincare(std::move(field), through, options);
    case Style::inner_product: return normalize_inner_product(std::move(field), through, options);
    case Style::hamiltonian: break;
    }
    refuse({"a normal form has a style that is built",
            to_string(style),
            "use style = \"poincare\" or \"inner_product\"",
            {}});
}

} // namespace resonform
