// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues and eigenvectors of a block of more than two states, where its characteristic polynomial falls
// into factors with closed roots: three oscillators in a chain, gyroscopic couplings of two. A multiple
// factor with one eigenvector has a chain of generalised ones in style inner_product: the Hamiltonian Hopf
// bifurcation.
#pragma once

#include "expand/modes/mode_blocks.hpp"

namespace resonform {

// Conventions of mode_blocks.hpp; the pivot of a mode (BlockMode::pivot) is the first entry of its column
// that does not vanish. The order: lower frequencies first where numbers (parameters near 1) decide it.
// Errors (refused): a factor without closed roots, not semisimple (in style inner_product: several chains of
// one eigenvalue), a sign that is not proved.
BlockModes modes_of_large_block(const Matrix& a, const System& system, const BlockName& name);
// Has every factor closed roots?
bool has_closed_modes(const Matrix& a, const System& system, const BlockName& name);

} // namespace resonform
