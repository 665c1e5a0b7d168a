// SPDX-License-Identifier: GPL-3.0-or-later
// The programs that compute one sweep together: resonform alone, or the ranks of resonform_mpi.
#pragma once

#include "cli/command.hpp"

#include <cstdint>
#include <functional>

namespace resonform {

struct SweepTeam {
    bool of_mpi = false;
    std::uint64_t rank = 0, size = 1; // 0 writes the result
    // Called when the scene is derived, its code compiled, and F.parts/ there.
    std::function<void()> prepared = [] {};
    // Called when this one's blocks are there; returns when those of all are, with the worst of their codes.
    std::function<int()> computed = [] { return 0; };

    [[nodiscard]] bool leads() const { return rank == 0; }
};

void add_sweep_of(CLI::App& app, Action& action, const SweepTeam& team);

} // namespace resonform
