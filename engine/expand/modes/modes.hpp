// SPDX-License-Identifier: GPL-3.0-or-later
// The modes of the linear part u' = A(xi) u of the fast variables at eps = 0, the slow ones frozen; A
// connects variables of one weight:
//
//   u_s = sum_j column_j[s] z_j,   z_j = sum_s row_j[s] u_s,   z_j' = lambda_j z_j     (design 2.2)
//
// or, in style inner_product, z_j' = lambda_j z_j + sum_k n_jk z_k where it is not semisimple (jordan_modes),
// over a complex pair column z + conj(column) zbar. Normalisation: in the pivot, the first state of its
// block, a pair has the column 1/2 (so u_pivot = (z + zbar)/2) and a real mode the column 1, unless couplings
// scale it. For psi'' + omega^2 psi this is z = psi - i psi'/omega.
#pragma once

#include "expand/ring/coefficient_ring.hpp"
#include "expand/ring/complex_expression.hpp"

#include <memory>

namespace resonform {

class NumericModes;

// n_jk: a mode that drives another one of the same eigenvalue.
struct ModeCoupling {
    std::size_t mode; // k
    Rational factor;
};

struct ModeShape {
    Complex eigenvalue;                       // im > 0: the first of a conjugate pair; im = 0: a real mode
    std::size_t pivot;                        // index into FirstOrderSystem::states
    std::vector<Complex> column, row;         // by index in ModalBasis::states
    std::vector<ModeCoupling> couplings = {}; // ascending

    [[nodiscard]] bool is_real() const { return eigenvalue.im.is_zero(); }
};

// A number that the ring knows by a generator of its own: growth or frequency of a mode.
struct NumberSymbol {
    GiNaC::symbol symbol;
    std::string name;
    std::size_t mode;
    bool growth;
};

struct ModalBasis {
    std::vector<std::size_t> states; // the fast ones, indices into FirstOrderSystem::states
    std::vector<ModeShape> modes;    // of a conjugate pair only the first; in the order of their pivots
    // Where some modes have no closed form: the shapes have neither columns nor rows then, and eigenvalues
    // without closed form are made of the symbols in `numbers`.
    std::shared_ptr<const NumericModes> numeric = nullptr;
    std::vector<NumberSymbol> numbers = {};

    // An uncoupled oscillator psi'' + omega^2 psi: z = psi - i psi'/omega.
    [[nodiscard]] bool is_oscillator(std::size_t mode, const FirstOrderSystem& system) const;
};

} // namespace resonform
