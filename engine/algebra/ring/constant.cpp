// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/constant.hpp"

#include <algorithm>

namespace resonform {

bool is_constant(const Ring& ring, const Polynomial& p) {
    return std::all_of(p.terms().begin(), p.terms().end(), [&](const Term& t) {
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            if (ring.exponent(t.monomial, id) == 0) continue;
            const GeneratorKind kind = ring.generator(id).kind;
            const bool constant_root =
                kind == GeneratorKind::root && is_constant(ring, ring.generator(id).radicand);
            if (kind != GeneratorKind::parameter && !constant_root) return false;
        }
        return true;
    });
}

} // namespace resonform
