// SPDX-License-Identifier: GPL-3.0-or-later
// Linear algebra in balls, with proved results.
#pragma once

#include "algebra/number/complex_ball.hpp"

#include <optional>
#include <vector>

namespace resonform {

using BallMatrix = std::vector<std::vector<ComplexBall>>; // rows

// A u = lambda u and l A = lambda l, with l u = 1 for each eigenvalue.
struct EigenSystem {
    std::vector<ComplexBall> values;
    BallMatrix columns, rows; // by eigenvalue: u and l
};

// nullopt: the eigenvalues could not be separated from each other at this precision (or are multiple).
std::optional<EigenSystem> simple_eigensystem(const BallMatrix& a, std::int64_t bits);

// a x = b; nullopt: a may be singular.
std::optional<std::vector<ComplexBall>> solution(const BallMatrix& a, const std::vector<ComplexBall>& b,
                                                 std::int64_t bits);

} // namespace resonform
