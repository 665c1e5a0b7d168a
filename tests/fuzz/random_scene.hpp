// SPDX-License-Identifier: GPL-3.0-or-later
// A random system and a scene of it, as a user would write the two files.
#pragma once

#include <cstdint>
#include <string>

namespace resonform::test {

struct WrittenScene {
    std::string system, scene; // the texts of system.toml and of the scene
    std::string roles;         // "2 fast, slow, angle"
    int order = 0;
};

// Fast variables (small or finite oscillators, alone, resonant, or canonical pairs), a slow variable (of
// explicit law, relaxing, or driven), an angle and drifts, with coefficients of 1 to 20 digits: in the
// equations, as parameters under [fix], or as exact expressions such as sqrt(2). The order is 1 ... 5 and
// lower for large systems, so that a derivation takes seconds. `attempt` is the next one of the same seed,
// after a scene that is refused.
//
// From seed 10,000 on at least one fast variable decays at eps = 0 (first order, spiral, or overdamped),
// beside an oscillator or alone, and coefficients hold functions of the slow variable.
constexpr std::uint64_t first_seed_of_decay = 10'000;
WrittenScene random_scene(std::uint64_t seed, int attempt);

} // namespace resonform::test
