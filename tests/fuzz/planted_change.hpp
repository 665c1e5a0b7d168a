// SPDX-License-Identifier: GPL-3.0-or-later
// Lies about a scene: one change in what is emitted, or one in the normal form that it comes from.
#pragma once

#include "emit/program/program.hpp"
#include "fuzz/draw.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <optional>
#include <string>

namespace resonform::test {

template <class Lie> struct Planted {
    Lie lie;
    std::string what; // "operand 2 of node 17 (add) times 1 + 3e-09"
};

// One operand of a sum or product scaled, dropped or doubled, another exponent, a sine for a cosine: anywhere
// in what is computed. nullopt: the node drawn has nothing to change, or the change is none.
std::optional<Planted<Program>> plant_in_program(const Program& program, Draw& draw);

// Another coefficient, of any size, of one monomial of the normal form or of the map. nullopt: there is none.
std::optional<Planted<Normalization>> plant_in_normal_form(const Normalization& truth, Draw& draw);

} // namespace resonform::test
