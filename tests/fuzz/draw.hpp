// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded choices: the same seed, the same scene and the same change on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace resonform::test {

class Draw {
public:
    // stream: of one seed several independent sequences are drawn.
    Draw(std::uint64_t seed, std::uint64_t stream) : random_(1'000'003 * seed + stream) {}

    int pick(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
    bool chance(int one_in) { return pick(one_in) == 0; }
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    template <class T> const T& any(const std::vector<T>& list) {
        return list[static_cast<std::size_t>(pick(static_cast<int>(list.size())))];
    }

private:
    std::mt19937_64 random_;
};

} // namespace resonform::test
