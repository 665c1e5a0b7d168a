// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/styles/normalize.hpp"

#include "normalize/styles/hamiltonian.hpp"
#include "normalize/styles/inner_product.hpp"

namespace resonform {

Normalization normalize(std::shared_ptr<const GradedField> field, int through,
                        const NormalizeOptions& options) {
    switch (field->system().style) {
    case Style::poincare: return normalize_poincare(std::move(field), through, options);
    case Style::inner_product: return normalize_inner_product(std::move(field), through, options);
    case Style::hamiltonian: break;
    }
    return normalize_hamiltonian(std::move(field), through, options);
}

} // namespace resonform
