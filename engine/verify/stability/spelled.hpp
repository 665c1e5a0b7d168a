// SPDX-License-Identifier: GPL-3.0-or-later
// A node of a program's graph as text for a reader, short:
//
//   add(1, multiply(-1, cos(flow tau)))   ->   1 - cos(tau)
//
// Symbols have the names that [start] and the equations give them, named parts of an output theirs ("psi_2");
// what is too deep for a line is "...".
#pragma once

#include "emit/program/program.hpp"

#include <string>

namespace resonform {

std::string spelled(const Program& program, Graph::Node n);

} // namespace resonform
