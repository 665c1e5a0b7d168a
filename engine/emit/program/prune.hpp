// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes of a graph are needed, and which of them change from call to call.
#pragma once

#include "emit/program/program.hpp"

#include <set>
#include <vector>

namespace resonform {

// flags[n]: node n is one of `roots` or an operand of one, however deep.
std::vector<bool> reachable(const Graph& graph, const std::vector<Graph::Node>& roots);

// flags[n]: node n is one of `sources` or depends on one.
std::vector<bool> depending(const Graph& graph, const std::set<Graph::Node>& sources);

// The symbols whose values differ from call to call: time, slow_time, values of the flow and of tables,
// cosines, sines; and whether a node depends on one.
std::set<Graph::Node> varying_symbols(const Program& program);
bool varies(const Program& program, Graph::Node n);

// Drops the flow, tables, phases, parameters, start values, conditions and names that outputs, state and
// declared start values do not need; inputs of these names stay.
void prune(Program& program, const std::set<std::string>& kept_inputs);

// Fills Program::data. Errors (refused): data stand at a slow variable whose motion is not even: nothing
// knows beforehand when it passes their breakpoints.
void find_data(Program& program);

} // namespace resonform
