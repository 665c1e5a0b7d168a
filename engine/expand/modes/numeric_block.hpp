// SPDX-License-Identifier: GPL-3.0-or-later
// The modes of one block of a linear part in numbers, to any precision.
#pragma once

#include "algebra/number/ball_matrix.hpp"
#include "algebra/series/number_domain.hpp"

#include <optional>
#include <vector>

namespace resonform {

// Polynomials without symbols: numbers, and roots and functions of numbers.
using NumberMatrix = std::vector<std::vector<Polynomial>>;

struct NumericMode {
    ComplexBall eigenvalue;               // of a pair the one with im > 0; re or im is exactly 0 where that
                                          // is proved
    std::vector<ComplexBall> column, row; // by place in the block, row . column = 1, of any scale

    [[nodiscard]] bool real() const { return eigenvalue.im().is_zero(); }
    [[nodiscard]] bool zero() const { return eigenvalue.is_zero(); }
    [[nodiscard]] bool undamped() const { return !real() && eigenvalue.re().is_zero(); }
};

// A closed mode, its entries converted.
struct ClosedMode {
    Polynomial eigenvalue;
    std::vector<Polynomial> column, row;
};

class NumericBlock {
public:
    NumericBlock(const Ring& ring, NumberMatrix a, std::vector<ClosedMode> closed);

    // Of a pair only the first; by frequency, then by growth. nullopt: more bits are needed to tell the
    // eigenvalues from each other. Exact properties are proved: it is real where no other one lies in
    // the ball of its conjugate, imaginary where besides the characteristic polynomial is even and no other
    // one lies in that of its negative conjugate, zero where the determinant is and no other one may be.
    [[nodiscard]] std::optional<std::vector<NumericMode>> modes(const NumberDomain& numbers) const;
    // Both have the same eigenvalues: their characteristic polynomials are the same.
    [[nodiscard]] bool is_isospectral(const NumericBlock& other) const {
        return characteristic_ == other.characteristic_;
    }
    [[nodiscard]] bool is_closed() const { return !closed_.empty(); }
    // With lambda, -lambda is an eigenvalue.
    [[nodiscard]] bool is_even() const { return even_; }

private:
    [[nodiscard]] std::vector<NumericMode> evaluated(const NumberDomain& numbers) const;

    NumberMatrix a_;
    std::vector<ClosedMode> closed_; // empty: solved in numbers
    std::vector<Polynomial> characteristic_;
    bool even_ = true, singular_ = false;
};

} // namespace resonform
