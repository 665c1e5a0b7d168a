// SPDX-License-Identifier: GPL-3.0-or-later
// Sums that are far smaller than their terms, rewritten so that fewer digits are lost.
#pragma once

#include "emit/graph/graph.hpp"

namespace resonform {

// A sum of two terms that is a difference of squares, factored; other nodes as they are. Of 4 w^2 - b^2
// nothing but the rounding of squares is left where b is close to 2 w:
//   4 w^2 - b^2   ->   (2 w - b) (2 w + b)
Graph::Node factored_difference(Graph& graph, Graph::Node sum);

// A sum in which multiples of other sums are multiplied out, if these have a symbol for a term: so constants
// meet first. Of a slow variable that starts close to a, a - s_0 is exact, a - (T + s_0) holds the rounding
// of s.
//   a - (T + s_0)   ->   a - T - s_0
Graph::Node multiplied_out(Graph& graph, Graph::Node sum);

} // namespace resonform
