// SPDX-License-Identifier: GPL-3.0-or-later
// The exact solution at many starts and times, computed in parallel, and kept in a cache.
#pragma once

#include "verify/symbolic/evaluator.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

struct SymbolicPoints {
    SymbolicInputs inputs;
    std::vector<Wide> times;
};

// [start][time]. From the cache, values have 47 digits, scales 15. `progress` is told how far the computation
// is, by one thread at a time.
std::vector<std::vector<SymbolicPoint>>
symbolic_values(const std::shared_ptr<const SymbolicSolution>& solution,
                const std::vector<SymbolicPoints>& points, const std::filesystem::path& cache,
                const std::function<void(const std::string&)>& progress);

} // namespace resonform
