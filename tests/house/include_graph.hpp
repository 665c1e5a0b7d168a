// SPDX-License-Identifier: GPL-3.0-or-later
// Which unit of the engine includes which. A unit is a header with its source: "algebra/ring".
#pragma once

#include "house/tree.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace resonform::test {

using IncludeGraph =
    std::map<std::string, std::set<std::string>>; // unit -> those it includes, without itself

// Of files below engine/.
IncludeGraph include_graph(const std::vector<SourceFile>& files);

// The sets of units that include each other, through others too: none can be read, tested or moved without
// the rest of its set. Each is sorted, and so are they.
std::vector<std::vector<std::string>> loops(const IncludeGraph& graph);

} // namespace resonform::test
