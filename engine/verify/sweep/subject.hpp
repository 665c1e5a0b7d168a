// SPDX-License-Identifier: GPL-3.0-or-later
// What a sweep is of: two sweeps of the same subject have the same numbers, and share their blocks.
#pragma once

#include "emit/display/json.hpp"
#include "verify/sweep/grid.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

// What is computed of each point: the outputs at some times, or of each output the quantities of the kind.
enum class SweepKind { values, verify, validity, stability };
std::vector<std::string> sweep_kinds();              // as --what names them, in this order
std::vector<std::string> quantities(SweepKind kind); // of values none
// How many closed solutions a point costs, about.
std::uint64_t cost_of_point(SweepKind kind);

struct SweepSubject {
    SweepKind what = SweepKind::values;
    double tolerance = 0; // of validity
    std::string system, scene;
    std::string code;              // a hash of the emitted code, and of all else in the scene that counts
    std::vector<std::string> over; // the axes as written
    std::optional<SweepSample> sample;
    std::vector<double> times; // empty: one, the end of the interval of each point
    std::string interval;      // as the scene writes it
    std::vector<std::string> outputs;
    std::string suffix; // of the output, ".npy", ".h5" or ".csv": for whoever gathers the blocks

    // Times or quantities.
    [[nodiscard]] std::uint64_t rows() const {
        return std::max<std::uint64_t>({1, times.size(), quantities(what).size()});
    }
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
