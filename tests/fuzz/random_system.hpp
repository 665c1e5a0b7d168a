// SPDX-License-Identifier: GPL-3.0-or-later
// Systems of every kind that a user can write, and a scene of each; unlike random scenes they may be refused.
// The distribution is the table of docs/design/28_coverage.md.
#pragma once

#include "fuzz/random_scene.hpp"

namespace resonform::test {

WrittenScene random_system(std::uint64_t seed);

} // namespace resonform::test
