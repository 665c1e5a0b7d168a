// SPDX-License-Identifier: GPL-3.0-or-later
// Time and memory of a task in this process.
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <chrono>

namespace resonform::bench {

inline double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The least time of at least three runs, and of as many as fit into half a second; a task of a minute is run
// once.
template <class Task> double least_seconds(Task task) {
    double least = 1e300, total = 0;
    for (int run = 0; run < 3 || (total < 0.5 && run < 100); ++run) {
        const auto start = std::chrono::steady_clock::now();
        task();
        const double time = seconds_since(start);
        least = std::min(least, time);
        total += time;
        if (total > 20) break;
    }
    return least;
}

// The largest the process has been.
inline double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

} // namespace resonform::bench
