// SPDX-License-Identifier: GPL-3.0-or-later
// The outputs of a scene as sums and products of atoms and turned modes: what the kernel of many points walks
// for each point (runtime/kernel/view.hpp, Operation). Atoms are what moves with slow time alone.
//
//   c s^2 cos(theta) sin(theta) + z   ->   atoms s^2, z;   p = cos sin, p = c p, p = z + s^2 p
#pragma once

#include "emit/program/straight_line.hpp"

#include <optional>
#include <vector>

namespace resonform {

struct Recipe {
    // In the order and with the names of the kernel's.
    enum class Kind {
        product,
        scaled,
        sum,
        difference,
        shifted,
        multiply_add,
        multiply_subtract,
        scaled_add,
        scaled_subtract,
        constant
    };
    struct Operation {
        Kind kind;
        int to, a, b, c; // slots, or of `a` the index of a constant
    };
    std::vector<StraightLine::Value> atoms, constants;
    std::vector<Operation> operations;
    std::vector<int> results; // slots of the outputs
    int turns = 0, fades = 0; // highest degrees in cosines and sines, and in exponentials
};

// Of program.outputs. Appends the atoms to `code`. nullopt: something else than sums and products turns, or
// the kernel has not so many slots.
std::optional<Recipe> recipe_of(const Program& program, StraightLine& code);

} // namespace resonform
