// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/expansion/graph_fit.hpp"

namespace resonform {

bool fits_graph(const GradedField& field) {
    if (field.system().style != Style::poincare) return false;
    for (GeneratorId id = 1; id < field.ring->size(); ++id)
        if (field.ring->is_algebraic(id)) return false;
    return true;
}

} // namespace resonform
