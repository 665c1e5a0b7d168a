// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a sweep: a grid, first axis slowest, or a sample.
#pragma once

#include "verify/sweep/axis.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

// N points, each coordinate drawn by SplitMix64 (Steele, Lea and Flood 2014): coordinate a of point i, of A
// axes, is its output number n = i A + a from the state S,
//
//   z = S + (n + 1) 9e3779b97f4a7c15,  z = (z ^ z >> 30) bf58476d1ce4e5b9,  z = (z ^ z >> 27)
//   94d049bb133111eb, u = ((z ^ z >> 31) >> 11) / 2^53          (modulo 2^64, in hexadecimal)
//
// so that a point depends on S and its place alone, and N points are the first of any larger sample.
struct SweepSample {
    std::uint64_t count = 0, seed = 0;
};

// A share in 0 <= u < 1, as above.
double drawn_share(std::uint64_t seed, std::uint64_t number);

class SweepGrid {
public:
    // over: one text for each axis. Errors (bad_input): those of Axis; a name twice; more than 2^40 points.
    SweepGrid(const std::vector<std::string>& over, std::optional<SweepSample> sample);

    [[nodiscard]] const std::vector<Axis>& axes() const { return axes_; }
    [[nodiscard]] const std::optional<SweepSample>& sample() const { return sample_; }
    [[nodiscard]] std::uint64_t points() const { return points_; }
    // The axes' lengths; of a sample N alone.
    [[nodiscard]] std::vector<std::uint64_t> shape() const;
    // A value for each axis.
    [[nodiscard]] std::vector<double> point(std::uint64_t i) const;
    // Those which the coordinate takes: along the axis of a grid, of every point of a sample.
    [[nodiscard]] const std::vector<double>& values(std::size_t axis) const { return values_[axis]; }

private:
    std::vector<Axis> axes_;
    std::optional<SweepSample> sample_;
    std::uint64_t points_ = 1;
    std::vector<std::vector<double>> values_;
};

} // namespace resonform
