// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a sweep, on several threads; those that are there already are kept.
#pragma once

#include "verify/sweep/folder.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace resonform {

// Sets numbers[point][row][column] and status[point][row] of `count` points. A point's numbers depend on it
// alone. Called from several threads.
using ComputePoints =
    std::function<void(std::uint64_t first, std::uint64_t count, double* numbers, unsigned char* status)>;

struct SweepShare {
    std::uint64_t part = 1, parts = 1; // blocks part - 1, part - 1 + parts, ...
    std::uint64_t jobs = 1;            // threads
    std::function<void(const std::string&)> progress;
};

// Errors: those of SweepFolder and of `compute`.
void compute_blocks(const SweepFolder& folder, const SweepSize& size, const ComputePoints& compute,
                    const SweepShare& share);

} // namespace resonform
