// SPDX-License-Identifier: GPL-3.0-or-later
// The machine that numbers and times come from.
#pragma once

#include <optional>
#include <string>

namespace resonform {

// The instructions that the numbers are computed with. Emitted code is compiled for the family of
// processors, but the library of functions chooses by the processor that it runs on.
std::string instruction_set();

struct Machine {
    std::string processor;    // "unknown" where the system does not tell
    std::string instructions; // instruction_set()
    std::string loops;        // the width of the loops for many points: "baseline", "avx2", "avx512", "neon"
    std::optional<double> load; // processes that wanted to run, on average over the last minute
    std::string compiler;       // of emitted code, with its flags
    int processors = 1;         // that this process may use
};
Machine this_machine();

// Holds this thread on the processor that it is on, as long as the object lives: a thread that is moved loses
// its caches.
class OnOneProcessor {
public:
    OnOneProcessor();
    ~OnOneProcessor();
    OnOneProcessor(const OnOneProcessor&) = delete;
    OnOneProcessor& operator=(const OnOneProcessor&) = delete;

    // nullopt: the system does not allow it.
    [[nodiscard]] std::optional<int> processor() const { return processor_; }

private:
    std::optional<int> processor_;
    std::string before_; // the processors that were allowed, as bytes
};

} // namespace resonform
