// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/compute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <vector>

namespace resonform {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Lines on standard error, more and more seldom.
class Progress {
public:
    Progress(const SweepShare& share, std::uint64_t points) : share_(share), points_(points) {}

    void done(std::uint64_t points, bool computed) {
        const std::lock_guard lock(mutex_);
        done_ += points;
        if (computed) computed_ += points;
        if (!share_.progress || seconds_since(told_) < std::max(least_pause, seconds_since(begin_) / 10))
            return;
        told_ = Clock::now();
        const double speed = static_cast<double>(computed_) / seconds_since(begin_);
        const std::string left =
            computed_ == 0 ? ""
                           : fmt::format(", {:.0f} s left", static_cast<double>(points_ - done_) / speed);
        share_.progress(fmt::format("{} of {} points{}", done_, points_, left));
    }

private:
    static constexpr double least_pause = 2; // seconds
    const SweepShare& share_;
    std::uint64_t points_, done_ = 0, computed_ = 0;
    Clock::time_point begin_ = Clock::now(), told_ = begin_;
    std::mutex mutex_;
};

SweepBlock computed_block(std::uint64_t b, const SweepSize& size, const ComputePoints& compute) {
    const Clock::time_point begin = Clock::now();
    SweepBlock block;
    block.numbers.resize(size.count(b) * size.rows * size.columns);
    block.status.resize(size.count(b) * size.rows);
    compute(size.first(b), size.count(b), block.numbers.data(), block.status.data());
    block.seconds = seconds_since(begin);
    return block;
}

} // namespace

void compute_blocks(const SweepFolder& folder, const SweepSize& size, const ComputePoints& compute,
                    const SweepShare& share) {
    const std::uint64_t blocks = size.blocks();
    std::uint64_t points = 0;
    for (std::uint64_t b = share.part - 1; b < blocks; b += share.parts) points += size.count(b);
    Progress progress(share, points);
    std::atomic<std::uint64_t> next = 0;
    std::atomic<bool> failed = false;
    const auto work = [&] {
        try {
            while (!failed) {
                const std::uint64_t b = share.part - 1 + share.parts * next++;
                if (b >= blocks) return;
                const bool there = folder.load(b, size).has_value();
                if (!there) folder.store(b, computed_block(b, size, compute));
                progress.done(size.count(b), !there);
            }
        } catch (...) {
            failed = true;
            throw;
        }
    };
    std::vector<std::future<void>> threads;
    for (std::uint64_t j = 0; j < std::min(share.jobs, blocks); ++j)
        threads.push_back(std::async(std::launch::async, work));
    for (auto& thread : threads) thread.wait(); // all of them, before an error unwinds what they use
    for (auto& thread : threads) thread.get();
}

} // namespace resonform
