// SPDX-License-Identifier: GPL-3.0-or-later
// A graded series: homogeneous parts by weight. The type of a part depends on the domain of the coefficients:
// a Polynomial of a Ring, a GraphPart of a graph.
#pragma once

#include "algebra/ring/ring.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace resonform {

// part(n) is the homogeneous part of weight n; weights past the end are zero.
template <class PartType> class BasicSeries {
public:
    using Part = PartType;

    BasicSeries() = default;
    explicit BasicSeries(std::vector<Part> parts) : parts_(std::move(parts)) {}
    static BasicSeries split(const Ring& ring, const Polynomial& p,
                             int through) requires std::same_as<Part, Polynomial> {
        return BasicSeries(ring.by_weight(p, through));
    }

    [[nodiscard]] const Part& part(int weight) const {
        static const Part zero;
        if (weight < 0 || weight > through()) return zero;
        return parts_[static_cast<std::size_t>(weight)];
    }
    void set(int weight, Part p) {
        const auto n = static_cast<std::size_t>(weight);
        if (n >= parts_.size()) parts_.resize(n + 1);
        parts_[n] = std::move(p);
    }
    [[nodiscard]] int through() const { return static_cast<int>(parts_.size()) - 1; }
    // All weights 0 ... through as one polynomial.
    [[nodiscard]] Part total(int through) const requires std::same_as<Part, Polynomial> {
        const int last = std::min(through, this->through());
        return sum(std::vector<Polynomial>(parts_.begin(), parts_.begin() + std::max(last + 1, 0)));
    }

    friend bool operator==(const BasicSeries&, const BasicSeries&) = default;

private:
    std::vector<Part> parts_;
};

using Series = BasicSeries<Polynomial>;

// [a b]_n = sum_j a_j b_{n-j}
Series multiply(const Ring& ring, const Series& a, const Series& b, int through);

} // namespace resonform
