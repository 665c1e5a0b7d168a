// SPDX-License-Identifier: GPL-3.0-or-later
// The nilpotent part of the homological operator, on the monomials of the modes:
//   (L_n c)_j = sum_ab n_ab w_b dc_j/dw_a - sum_k n_jk c_k
#pragma once

#include "expand/expansion/graded_field.hpp"

#include <utility>
#include <vector>

namespace resonform {

// A monomial as a component of a vector: that of a mode, or -1 of a variable by itself.
struct VectorMonomial {
    int mode;
    Monomial monomial;

    friend bool operator<(const VectorMonomial& a, const VectorMonomial& b) {
        return a.mode != b.mode ? a.mode < b.mode : a.monomial < b.monomial;
    }
};

class NilpotentFlow {
public:
    explicit NilpotentFlow(const GradedField& field);

    // w_to' holds factor * w_from: modes and their conjugates.
    struct Step {
        GeneratorId to, from;
        Rational factor;
    };
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    // n_jk for the mode j: none for -1.
    [[nodiscard]] const std::vector<ModeCoupling>& row(int mode) const;

    using Image = std::vector<std::pair<VectorMonomial, Rational>>;
    // L_n of one monomial; a monomial may be listed more than once.
    [[nodiscard]] Image image(const VectorMonomial& v) const;
    // All monomials in whose image v may occur.
    [[nodiscard]] std::vector<VectorMonomial> sources(const VectorMonomial& v) const;
    // <v, v>: the product of the factorials of the exponents of the modes.
    [[nodiscard]] Rational square(const VectorMonomial& v) const;

private:
    const GradedField& field_;
    std::vector<Step> steps_;
    std::vector<GeneratorId> modes_; // generators of modes and conjugates
};

} // namespace resonform
