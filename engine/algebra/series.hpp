// SPDX-License-Identifier: GPL-3.0-or-later
// A graded series: homogeneous parts by weight, each a Polynomial of a Ring.
#pragma once

#include "algebra/ring.hpp"

#include <vector>

namespace resonform {

// part(n) is the homogeneous part of weight n; weights past the end are zero.
class Series {
public:
    Series() = default;
    explicit Series(std::vector<Polynomial> parts) : parts_(std::move(parts)) {}
    static Series split(const Ring& ring, const Polynomial& p, int through);

    [[nodiscard]] const Polynomial& part(int weight) const;
    void set(int weight, Polynomial p);
    [[nodiscard]] int through() const { return static_cast<int>(parts_.size()) - 1; }
    // All weights 0 ... through as one polynomial.
    [[nodiscard]] Polynomial total(int through) const;

private:
    std::vector<Polynomial> parts_;
};

// [a b]_n = sum_j a_j b_{n-j}
Polynomial product_part(const Ring& ring, const Series& a, const Series& b, int weight);
Series multiply(const Ring& ring, const Series& a, const Series& b, int through);

} // namespace resonform
