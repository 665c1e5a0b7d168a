// SPDX-License-Identifier: GPL-3.0-or-later
// How large a sweep is, and into which blocks it is divided.
#pragma once

#include <cstdint>
#include <vector>

namespace resonform {

// Of numbers in the answer of a sweep: 8 TB.
constexpr std::uint64_t most_numbers = std::uint64_t(1) << 40;

// The product of numbers that are at most 2^40 each. Errors (bad_input): it is larger than most_numbers.
std::uint64_t bounded_product(const std::vector<std::uint64_t>& factors);

// A point has rows, the times or the quantities asked for, of columns: what is kept of each.
struct SweepSize {
    std::uint64_t points = 0, rows = 0, columns = 0;
    std::uint64_t block = 0; // points in a block; fewer in the last

    [[nodiscard]] std::uint64_t blocks() const { return (points + block - 1) / block; }
    [[nodiscard]] std::uint64_t first(std::uint64_t b) const { return b * block; }
    [[nodiscard]] std::uint64_t count(std::uint64_t b) const {
        return b + 1 < blocks() ? block : points - b * block;
    }
};

// Blocks of 2^16 numbers, of fewer where one costs as much as `cost` of a closed solution; larger ones where
// these would be more than 2^16; smaller ones where they would be fewer than 256: so there is work for every
// machine, and a kill loses little of it. Precondition: the product of the first three is below 2^63.
SweepSize size_of_sweep(std::uint64_t points, std::uint64_t rows, std::uint64_t columns,
                        std::uint64_t cost = 1);

} // namespace resonform
