// SPDX-License-Identifier: GPL-3.0-or-later
// The normal form of a field in the style that its system asks for.
#pragma once

#include "normalize/recursion/poincare.hpp"

namespace resonform {

// 1 <= through <= 99. The certificate is left empty.
// Errors: those of the style.
Normalization normalize(std::shared_ptr<const GradedField> field, int through,
                        const NormalizeOptions& options = {});

} // namespace resonform
