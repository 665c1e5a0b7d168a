// SPDX-License-Identifier: GPL-3.0-or-later
// The roots of an irreducible polynomial of degree one, two, or of degree four in even powers.
//
//   lambda^4 + b lambda^2 + c with b, c, b^2 - 4c > 0:   lambda = i w, i sqrt(c)/w,
//   w = sqrt(b/2 + sqrt(b^2/4 - c)); where c = n^2, w = alpha + beta and n/w = alpha - beta
//
// so that roots of different names are independent and coefficients stay canonical.
#pragma once

#include "expand/modes/mode_blocks.hpp"
#include "expand/ring/complex_expression.hpp"

#include <vector>

namespace resonform {

struct EigenRoot {
    std::vector<Complex> powers; // 1, lambda, ...: as many as the degree
    Complex value;               // im > 0: the first of a conjugate pair; im = 0: real
};

// f = lambda^n + lower[n-1] lambda^(n-1) + ... + lower[0]; lower frequencies first.
// Errors (refused): a higher degree; a sign that decides between real and complex is not proved.
std::vector<EigenRoot> closed_roots(const std::vector<GiNaC::ex>& lower, const System& system,
                                    const BlockName& name);

} // namespace resonform
