// SPDX-License-Identifier: GPL-3.0-or-later
// An expression of the user's files -> nodes of a graph, independent of the order in which GiNaC keeps
// its terms: operands are taken in the order of their spelling.
#pragma once

#include "algebra/number/error.hpp"
#include "algebra/number/functions.hpp"
#include "emit/graph/graph.hpp"

#include <ginac/ginac.h>

#include <functional>
#include <map>
#include <string>

namespace resonform {

// The node of the derivative-th derivative of a function that is known by its name.
using NamedNode = std::function<Graph::Node(const std::string& name, int derivative, Graph::Node x)>;

// names: the node of each symbol.
// Errors (refused): a function other than sin, cos, tan, exp, log, sqrt, asinh, named ones (if `named` is
// given) and rational powers, unless it is one of a number: `place` is where the user wrote it;
// std::logic_error: a symbol without a node (the readers of files exclude it).
Graph::Node from_expression(Graph& graph, const GiNaC::ex& e, const std::map<std::string, Graph::Node>& names,
                            const Place& place = {}, const NamedNode& named = {});

// f(x) by the functions that the runtime has, without loss of digits. Precondition: f is not `named`.
Graph::Node function_node(Graph& graph, Function f, Graph::Node x);

} // namespace resonform
