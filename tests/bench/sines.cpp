// SPDX-License-Identifier: GPL-3.0-or-later
// The yardstick of evaluators: a vectorised sine and cosine, compiled once for each width (SINES: its name).
#include "runtime/kernel/block.hpp"

#include <cstddef>

void SINES(const double* t, std::size_t n, double* c, double* s);

void SINES(const double* t, std::size_t n, double* c, double* s) {
    using namespace resonform::kernel;
    using L = Lanes<lanes>;
    constexpr std::size_t together = RESONFORM_VECTORS, width = lanes;
    for (std::size_t i = 0; i + together * width <= n; i += together * width)
        for (std::size_t k = 0; k < together; ++k) {
            const std::size_t at = i + k * width;
            const auto x = L::product(L::load(t + at), L::all(0.6366197723675814)); // quarter turns
            const auto turned = x + L::all(rounding_shift), f = x - (turned - L::all(rounding_shift));
            L::Vector cosine, sine;
            cosine_and_sine<lanes>(f, turned, cosine, sine);
            L::store(c + at, cosine);
            L::store(s + at, sine);
        }
}
