// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of work that do not need each other, on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace resonform {

// f(0) ... f(n - 1), each once, in any order, on at most eight threads. An error of f is thrown when all
// threads have ended.
template <class F> void in_parallel(std::size_t n, const F& f) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t k = next++; k < n; k = next++) f(k);
    };
    const std::size_t threads =
        std::min<std::size_t>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U), n);
    std::vector<std::future<void>> running;
    for (std::size_t k = 0; k < threads; ++k) running.push_back(std::async(std::launch::async, work));
    for (auto& thread : running) thread.wait(); // before an error unwinds what they use
    for (auto& thread : running) thread.get();
}

} // namespace resonform
