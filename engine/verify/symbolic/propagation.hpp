// SPDX-License-Identifier: GPL-3.0-or-later
// How well the variables y of a slow flow y' = f(T, y) can be known where the last places of their start
// values and of the terms of their rates are not:
//
//   S_k(T) = sum_j |P_kj(T, 0)| |y_j(0)| + int_0^T sum_j |P_kj(T, s)| (sum |terms of f_j|)(s) ds
//
// P propagates small differences, P' = df/dy P. A value that
// passes through zero keeps the scale of what cancels there, one that runs towards a singularity gets its
// condition, and one that is damped forgets. To one digit or two: a scale needs no more.
#pragma once

#include "verify/run/real.hpp"

#include <functional>
#include <vector>

namespace resonform {

class SymbolicPropagation {
public:
    using Values = std::vector<Float128>;
    struct Flow {
        std::function<Values(const Float128& T)> solution;
        std::function<Values(const Float128&T, const Values&y)> rates, terms; // f; sum |terms of f|
    };
    SymbolicPropagation(const Flow& flow, const Float128& end);
    // S_k at 0 <= T <= end.
    [[nodiscard]] std::vector<long double> operator()(const Float128& T) const;

private:
    using Row = std::vector<long double>;
    using Matrix = std::vector<Row>;
    [[nodiscard]] static Matrix slopes(const Flow& flow, const Float128& T, const Row& sizes);
    void carry_on(const Flow& flow, const Float128& left);
    [[nodiscard]] Row sums() const;

    Float128 piece_;
    Matrix differences_;      // [k][source]: what each source has become of y_k
    std::vector<Row> scales_; // at the ends of all pieces
};

} // namespace resonform
