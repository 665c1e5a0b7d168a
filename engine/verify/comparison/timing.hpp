// SPDX-License-Identifier: GPL-3.0-or-later
// How long a piece of work takes, over several runs.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace resonform {

struct Timing {
    double median = 0, low = 0, high = 0; // seconds
    int repetitions = 0;

    [[nodiscard]] Timing scaled(double factor) const {
        return {median * factor, low * factor, high * factor, repetitions};
    }
};

template <class Work> double seconds_of(int times, Work&& work) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i) work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / times;
}

// Reads the clock `repetitions` times; 0: at least three times, and no more after a fifth of a second.
// The work runs once before; with 0, where that takes longer than half a second it is the only run.
template <class Work> Timing measure(int repetitions, Work&& work) {
    constexpr double enough_time = 0.2; // seconds after which nothing is repeated any more
    constexpr int fewest_repetitions = 3, most_repetitions = 15;
    constexpr double shortest_reading = 2e-5; // seconds on the clock: shorter work is repeated
    constexpr double long_work = 0.5;         // seconds: beside it what a first run costs more is nothing
    const double first = seconds_of(1, work);
    if (repetitions == 0 && first > long_work) return {first, first, first, 1};
    const int each =
        static_cast<int>(std::clamp(std::ceil(shortest_reading / std::max(first, 1e-9)), 1.0, 1e4));
    std::vector<double> readings;
    double spent = 0;
    const auto is_enough = [&] {
        const auto count = static_cast<int>(readings.size());
        if (repetitions > 0) return count >= repetitions;
        return count >= fewest_repetitions && (count >= most_repetitions || spent >= enough_time);
    };
    while (!is_enough()) {
        readings.push_back(seconds_of(each, work));
        spent += each * readings.back();
    }
    std::sort(readings.begin(), readings.end());
    const std::size_t half = readings.size() / 2;
    const double median =
        readings.size() % 2 == 1 ? readings[half] : (readings[half - 1] + readings[half]) / 2;
    return {median, readings.front(), readings.back(), static_cast<int>(readings.size())};
}

} // namespace resonform
