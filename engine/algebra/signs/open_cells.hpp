// SPDX-License-Identifier: GPL-3.0-or-later
// The signs of a polynomial where others are positive, at a point of each open cell into which the zeros of
// all of them cut space (open cylindrical decomposition: A. Strzebonski, J. Symbolic Comput. 29 (2000)
// 471-480).
//
//   x*y - 1 where x, y > 0   ->   both signs, and zero         x^2 - y where y < 0   ->   positive
#pragma once

#include "algebra/ring/integer_polynomial.hpp"
#include "algebra/signs/sign_set.hpp"

#include <optional>
#include <vector>

namespace resonform {

// Zero is in the set if the sign of `asked` changes within the domain; if it does not, `asked` may still
// vanish at a point, where its slopes vanish, too. An empty set: the domain is empty. `factors` are the
// irreducible factors of all conditions and of `asked`, which is square-free. nullopt: the elimination takes
// more than the budgets below.
std::optional<SignSet> signs_on_open_cells(const Packed& asked, const std::vector<Packed>& conditions,
                                           const std::vector<Packed>& factors);

// The cost of an elimination grows doubly exponentially with the number of variables. With these, the slowest
// proof takes about as long as a compiler needs to start.
constexpr std::size_t most_variables = 6;
constexpr slong highest_degree = 24;         // of both polynomials of a resultant
constexpr slong most_products = 100;         // of a term of the one and a term of the other
constexpr std::size_t most_polynomials = 24; // in the variables that are left
constexpr int most_cells = 3000;

} // namespace resonform
