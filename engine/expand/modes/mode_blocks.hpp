// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues and eigenvectors of one block of the linear part, in closed form.
#pragma once

#include "expand/ring/complex_expression.hpp"
#include "model/exact/first_order_system.hpp"

#include <vector>

namespace resonform {

using Matrix = std::vector<std::vector<GiNaC::ex>>;

// A row of the inverse of the matrix of columns belongs to each column; of a conjugate pair only the
// first is listed. The pivot of a column, mostly its first entry, is 1 (real eigenvalue) or 1/2 (complex
// pair).
struct BlockMode {
    Complex eigenvalue;
    std::vector<Complex> column, row;
    std::size_t pivot = 0; // the entry of the column that is 1 or 1/2
};

struct BlockModes {
    std::vector<BlockMode> modes;
    bool chained = false; // not semisimple: later modes drive earlier ones, and no first entry is promised
};

// The name of a block in messages.
struct BlockName {
    std::string variables; // "x", "x, y"
    bool oscillator;       // the block of one variable of second order
    Place place;           // of the equation of the first
};

// The states of a block, of which none can be split off: one, or two.
// Errors (refused): not semisimple, in a style that is not for that; the sign of the discriminant is not
// proved.
BlockModes modes_of_block(const Matrix& a, const System& system, const BlockName& name);

// u'' = -k u for two variables of second order, k of full rank and with real eigenvalues; the states are
// u1, u1', u2, u2'. Errors: as above.
BlockModes modes_of_coupled_oscillators(const Matrix& k, const System& system, const BlockName& name);

// Can it be proved that the eigenvalues of k are equal, or that they are real and of which signs?
bool has_plain_frequencies(const Matrix& k, const System& system);

} // namespace resonform
