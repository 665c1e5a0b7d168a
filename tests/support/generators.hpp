// SPDX-License-Identifier: GPL-3.0-or-later
// Generators of rings that a test makes by hand.
#pragma once

#include "algebra/ring/ring.hpp"

#include <string>

namespace resonform::test {

// Divided by where it is positive; of weight 1 if it is fast or small.
inline Generator named(GeneratorKind kind, const std::string& name, bool positive = false) {
    Generator g;
    g.kind = kind;
    g.name = name;
    g.positive = positive;
    g.invertible = positive;
    g.weight = kind == GeneratorKind::fast || kind == GeneratorKind::small ? 1 : 0;
    return g;
}

// radicand^(1/index) > 0
inline Generator root_of(const std::string& name, int index, const Polynomial& radicand) {
    Generator g = named(GeneratorKind::root, name, true);
    g.index = index;
    g.radicand = radicand;
    return g;
}

} // namespace resonform::test
