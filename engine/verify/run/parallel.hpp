// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of work that do not need each other, on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <future>
#include <thread>
#include <vector>

namespace resonform {

// How many pieces of work are done at a time: as many as the machine has threads, at most eight.
inline std::size_t side_by_side() { return std::clamp(std::thread::hardware_concurrency(), 1U, 8U); }

// f(0) ... f(n - 1), each once, in any order. After an error no further piece is begun; that of the least k
// is thrown when all threads have ended, as if the pieces had been done one after the other. (Pieces are
// begun in their order, so that with k all before it have been.)
template <class F> void in_parallel(std::size_t n, const F& f) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    std::vector<std::exception_ptr> errors(n);
    const auto work = [&] {
        while (!failed)
            if (const std::size_t k = next++; k < n) {
                try {
                    f(k);
                } catch (...) {
                    errors[k] = std::current_exception();
                    failed = true;
                }
            } else {
                return;
            }
    };
    std::vector<std::future<void>> others; // beside this thread
    for (std::size_t k = 1; k < std::min(side_by_side(), n); ++k)
        others.push_back(std::async(std::launch::async, work));
    work();
    for (auto& thread : others) thread.wait();
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
}

} // namespace resonform
