// SPDX-License-Identifier: GPL-3.0-or-later
// What the operands of a graph's nodes do to an output.
#pragma once

#include "emit/graph/graph.hpp"
#include "verify/symbolic/terms.hpp"

#include <vector>

namespace resonform {

// d output/d node of every node, the others held: 0 of those that it is not computed from. values: of all
// nodes behind it. Precondition: no callables.
std::vector<Wide> slopes_of_output(const Graph& graph, Graph::Node output, const std::vector<Wide>& values);

} // namespace resonform
