// SPDX-License-Identifier: GPL-3.0-or-later
// The values over which one argument of a sweep goes, as the command line writes them:
//
//   NAME=LO:HI:N        LO + (HI - LO) i/(N - 1),               i = 0 ... N - 1
//   NAME=log(LO:HI:N)   exp(log LO + (log HI - log LO) i/(N - 1))
//   NAME=V1,V2,...      these
//
// Numbers are read exactly and rounded once; between the ends is computed in 113 bits. So a value depends on
// the text alone, not on the machine or its library of functions.
#pragma once

#include "runtime/float128.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace resonform {

enum class Spacing { linear, logarithmic, list };
const char* to_string(Spacing spacing);

// Of one axis.
constexpr std::uint64_t most_values = std::uint64_t(1) << 24;

class Axis {
public:
    // sampled: the values are drawn, so N may be left out. Errors (bad_input): the text is none of the above;
    // a number is no double; LO > HI; in a logarithm LO <= 0; N is not in 1 ... most_values, or 1 with two
    // ends.
    Axis(const std::string& text, bool sampled);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] Spacing spacing() const { return spacing_; }
    [[nodiscard]] std::uint64_t count() const { return count_; }
    // Of place i, in 0 ... count - 1.
    [[nodiscard]] double value(std::uint64_t i) const;
    // The value below which lies the share u of the axis, 0 <= u < 1: uniform in LO ... HI, in its logarithm,
    // or among the values of a list.
    [[nodiscard]] double drawn(double u) const;
    [[nodiscard]] double least() const;
    [[nodiscard]] double largest() const;

private:
    void read_list(const std::string& text);
    void read_range(const std::string& text, bool sampled);
    [[nodiscard]] double between(const Float128& share) const;

    std::string name_;
    Spacing spacing_ = Spacing::list;
    std::uint64_t count_ = 0;
    std::vector<double> list_;
    Float128 low_ = 0, high_ = 0; // of a logarithmic axis too
};

} // namespace resonform
