// SPDX-License-Identifier: GPL-3.0-or-later
// The modes of a linear part that consists of numbers: columns, rows and eigenvalues are balls that are
// proved to hold the true ones, to any precision. Blocks without closed roots are solved as they are; columns
// and rows are continued to the blocks that they drive, or that drive them.
//
//   x'' = -2 x + y,  y'' = -3 y + x + w,  w'' = -5 w + y:   three undamped pairs; omega = 1.08..., ...
#pragma once

#include "expand/modes/mode_blocks.hpp"
#include "expand/modes/numeric_block.hpp"
#include "expand/ring/coefficient_ring.hpp"

#include <optional>
#include <vector>

namespace resonform {

class NumericModes {
public:
    // A block of states, ascending, with its modes if they are known in closed form.
    struct BlockOfStates {
        std::vector<std::size_t> states;
        std::optional<std::vector<BlockMode>> closed;
    };
    struct Shape {
        std::size_t pivot; // the state whose entry of the column is 1 (real mode) or 1/2 (pair)
        bool real = false, undamped = false; // the imaginary, the real part of lambda is 0
        std::optional<Complex> eigenvalue;   // in closed form
        std::size_t like;                    // the first mode that is known to have the same eigenvalue
        std::optional<std::size_t> mirror;   // a mode before whose eigenvalue is known to be -conj(lambda)
    };

    // a: the linear part; drives[t][s]: state t reaches the rate of state s. Blocks in the order of their
    // first states. Errors (refused): symbols in a, eigenvalues that cannot be separated, a mode that is
    // driven at its own eigenvalue (or that cannot be excluded).
    NumericModes(const Matrix& a, std::vector<std::vector<bool>> drives,
                 const std::vector<BlockOfStates>& blocks, CoefficientRing coefficients, const Place& place);

    [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }

    struct Values {
        std::vector<ComplexBall> eigenvalues; // by mode
        BallMatrix columns, rows;             // by mode and state
    };
    // nullopt: more bits are needed.
    [[nodiscard]] std::optional<Values> at(std::int64_t bits) const;

private:
    using Found = std::vector<std::vector<NumericMode>>; // by block
    struct Numbers {
        std::int64_t bits;
        BallMatrix a;
    };

    void add_blocks(const Matrix& a, const std::vector<BlockOfStates>& blocks,
                    const CoefficientRing& coefficients, const Place& place);
    void find_shapes(const std::vector<BlockOfStates>& blocks, const Place& place);
    void add_shapes(const std::vector<NumericMode>& modes, const BlockOfStates& block);
    [[nodiscard]] NumberDomain domain(std::int64_t bits) const;
    [[nodiscard]] std::optional<Found> found(const NumberDomain& domain) const;
    [[nodiscard]] std::optional<Values> values(const Found& modes, const NumberDomain& domain) const;
    // A column (a row) of a block, continued over the others.
    [[nodiscard]] std::optional<std::vector<ComplexBall>> extended(const std::vector<ComplexBall>& own,
                                                                   const ComplexBall& eigenvalue,
                                                                   std::size_t block, bool rows,
                                                                   const Numbers& numbers) const;

    std::vector<std::vector<bool>> drives_;
    RingPtr ring_; // of the entries
    NumberMatrix a_;
    std::vector<std::vector<std::size_t>> states_; // of each block
    std::vector<NumericBlock> blocks_;
    std::vector<std::size_t> first_shapes_; // of each block
    std::vector<Shape> shapes_;             // block by block
};

} // namespace resonform
