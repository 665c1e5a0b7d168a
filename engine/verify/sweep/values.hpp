// SPDX-License-Identifier: GPL-3.0-or-later
// The outputs of a scene over a grid: each point's arguments, by the ensemble form of the emitted code.
#pragma once

#include "verify/evaluate/ensemble.hpp"
#include "verify/sweep/grid.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace resonform {

class SweepValues {
public:
    // times: empty: the end of each point's interval. Errors: those of places_of_axes and EnsembleLibrary.
    SweepValues(std::shared_ptr<const Program> program, const Scene& scene, const SweepGrid& grid,
                std::vector<double> times, const std::filesystem::path& cache,
                const std::function<void(const std::string&)>& progress);

    // ComputePoints: rows are the times; columns are the time and the outputs.
    void operator()(std::uint64_t first, std::uint64_t count, double* numbers, unsigned char* status) const;

private:
    std::shared_ptr<const Program> program_;
    const SweepGrid& grid_;
    std::vector<double> times_;
    std::vector<std::size_t> place_; // of each axis among the arguments
    EnsembleLibrary library_;
};

} // namespace resonform
