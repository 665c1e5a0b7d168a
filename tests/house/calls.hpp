// SPDX-License-Identifier: GPL-3.0-or-later
// Which functions a file of the engine calls whose header it does not include itself.
#pragma once

#include "house/tree.hpp"

#include <string>
#include <vector>

namespace resonform::test {

// "expand/modes/modes.cpp calls refuse of algebra/number/error.hpp", for functions that one header below
// engine/ declares in a namespace, and that no class has a member of the name of. What the header of a unit
// includes its source has, too. A scan of the text: what stands after a name of a type is a declaration, what
// stands after . -> :: belongs to something else.
std::vector<std::string> calls_without_include(const std::vector<SourceFile>& files);

} // namespace resonform::test
