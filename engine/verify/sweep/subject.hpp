// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep is of: two sweeps of the same subject have the same numbers, and share their blocks.
#pragma once

#include "emit/display/json.hpp"
#include "verify/sweep/grid.hpp"

#include <optional>
#include <string>
#include <vector>

namespace resonform {

enum class SweepKind { values, validity };
std::vector<std::string> sweep_kinds(); // as --what names them, in this order

struct SweepSubject {
    SweepKind what = SweepKind::values;
    double tolerance = 0; // of validity
    std::string system, scene;
    std::string code;              // a hash of the emitted code: of everything in the scene that counts
    std::vector<std::string> over; // the axes as written
    std::optional<SweepSample> sample;
    std::vector<double> times; // empty: one, the end of the interval of each point
    std::string interval;      // as the scene writes it
    std::vector<std::string> outputs;
    std::string suffix; // of the output, ".npy" or ".csv": for whoever gathers the blocks

    [[nodiscard]] std::uint64_t rows() const { return times.empty() ? 1 : times.size(); }
    // Time and outputs.
    [[nodiscard]] std::uint64_t columns() const { return 1 + outputs.size(); }
};

// With version and instruction set, and the values of the grid as a hash.
Json subject_json(const SweepSubject& subject, const SweepGrid& grid);
// Errors (bad_input): it is not what subject_json wrote.
SweepSubject subject_of(const Json& json);

// The first key in which they differ, apart from the suffix and from how the axes are written; "" if there is
// none.
std::string difference(const Json& one, const Json& other);
// A hash of all that difference() looks at.
std::string identity(const Json& subject);

} // namespace resonform
