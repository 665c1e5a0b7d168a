// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials of a normal form as real and imaginary part, for computers: z = eps^w (u + i v),
// zbar = eps^w (u - i v), of a real mode z = eps^w u; e^{i phi} = u + i v with u^2 + v^2 = 1.
//
//   -i eps^3 z1 zbar1/2 (weights 1)   ->   0, -eps^5 (u^2 + v^2)/2
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <map>
#include <optional>
#include <utility>

namespace resonform {

class RealForm {
public:
    explicit RealForm(const GradedField& field);

    // eps, parameters, slow variables and roots of the normal form's ring by their names; u and v of every
    // mode and angle. They are independent: nothing is reduced by u^2 + v^2 = 1.
    [[nodiscard]] const RingPtr& ring() const { return ring_; }
    struct Pair {
        GeneratorId u, v; // v = -1: of a real mode
        [[nodiscard]] bool is_real() const { return v < 0; }
    };
    [[nodiscard]] const std::vector<Pair>& modes() const { return modes_; }
    [[nodiscard]] const std::vector<Pair>& angles() const { return angles_; }
    // u^2 + v^2 of a mode; -1: it is real. They appear in harmonics(), and in operator() for the modes of its
    // of_modulus.
    [[nodiscard]] const std::vector<GeneratorId>& moduli() const { return moduli_; }
    [[nodiscard]] const std::vector<GeneratorId>& slow() const { return slow_; }
    [[nodiscard]] GeneratorId eps() const { return eps_; }

    struct Value {
        Polynomial re, im;
    };
    // of_modulus: true for the modes whose product z zbar is written as their modulus; empty: none.
    [[nodiscard]] Value operator()(const Polynomial& p, const std::vector<bool>& of_modulus = {}) const;

    // p by what its terms turn with, nothing multiplied out: the sum of
    //
    //   coefficient * prod (u + i v)^turn, of a negative turn (u - i v)^-turn
    //
    // over modes, then angles; the coefficient holds powers of the moduli and of u of real modes, whose turns
    // are 0.
    struct Harmonic {
        std::vector<int> turns;
        Value coefficient;
    };
    [[nodiscard]] std::vector<Harmonic> harmonics(const Polynomial& p) const;
    // An upper bound of the number of terms of operator()(p).
    [[nodiscard]] std::size_t length(const Polynomial& p) const;

private:
    [[nodiscard]] std::vector<GeneratorId> turning() const;
    [[nodiscard]] const Polynomial& power(std::size_t unit, int exponent) const;

    const GradedField& field_;
    RingPtr ring_;
    std::vector<Pair> modes_, angles_;
    std::vector<GeneratorId> slow_, moduli_;
    GeneratorId eps_ = -1;
    std::vector<GeneratorId> outer_; // z1, zbar1, ..., e^{i phi}, ...
    std::vector<Polynomial> units_;  // their images
    std::optional<RingMap> lift_;    // for polynomials free of outer_
    mutable std::vector<std::vector<Polynomial>> powers_;
};

} // namespace resonform
