// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of the blocks of a sweep: F.npy, F.h5 or F.csv, and F.json.
#pragma once

#include "verify/sweep/folder.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace resonform {

struct SweepTotals {
    std::uint64_t done = 0;                      // points
    std::uint64_t blocks = 0, first_missing = 0; // that are there; the first that is not, if one is not
    std::map<unsigned char, std::uint64_t> statuses;
    double seconds = 0; // of all threads together
};

// The blocks that are there, in their order, each read once.
SweepTotals read_blocks(const SweepFolder& folder, const SweepSize& size,
                        const std::function<void(std::uint64_t b, const SweepBlock&)>& each);

// HDF5, with "values", "axes/NAME" for each axis and "t", the times or the end of each point; or
// NumPy format 1.0; both float64 in C order, of shape [axes ..., t or quantities, outputs]; or CSV with a
// line for each point and time or quantity, which is named where there are several. By the suffix of `file`.
// Bytes depend on the subject alone. Precondition: all blocks are there, else totals say so and nothing is
// written. Errors (bad_input): it cannot be written.
SweepTotals write_result(const std::filesystem::path& file, const SweepFolder& folder,
                         const SweepSubject& subject, const SweepGrid& grid, const SweepSize& size);

// resonform.sweep/1
Json sweep_json(const Json& subject_file, const SweepSubject& subject, const SweepGrid& grid,
                const SweepTotals& totals);

} // namespace resonform
