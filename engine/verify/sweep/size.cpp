// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/size.hpp"

#include "algebra/number/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace resonform {

namespace {

constexpr std::uint64_t usual_numbers = std::uint64_t(1) << 16, most_blocks = std::uint64_t(1) << 16;
constexpr std::uint64_t least_blocks = 256;

} // namespace

std::uint64_t bounded_product(const std::vector<std::uint64_t>& factors) {
    std::uint64_t product = 1;
    for (const std::uint64_t factor : factors) {
        if (factor > 0 && product > most_numbers / factor)
            bad_input(Reason::command_line, {"a sweep has at most 2^40 numbers: points x times x outputs",
                                             fmt::format("{}", fmt::join(factors, " x ")),
                                             "take fewer points, or sweep the range in parts",
                                             {}});
        product *= factor;
    }
    return product;
}

SweepSize size_of_sweep(std::uint64_t points, std::uint64_t rows, std::uint64_t columns, std::uint64_t cost) {
    const auto parts = [points](std::uint64_t n) { return (points + n - 1) / n; };
    const std::uint64_t usual = std::max<std::uint64_t>(1, usual_numbers / (rows * columns * cost));
    return {points, rows, columns, std::max(parts(most_blocks), std::min(usual, parts(least_blocks)))};
}

} // namespace resonform
