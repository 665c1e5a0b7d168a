// SPDX-License-Identifier: GPL-3.0-or-later
// In which order an eigenvector of one block of the linear part is continued over the others.
#pragma once

#include <cstddef>
#include <vector>

namespace resonform {

// The blocks to which `block` leads, each after all that lead to it. A block is a list of states;
// drives[t][s]: state t reaches the rate of state s. Columns lead to the blocks that are driven, rows to
// those that drive.
std::vector<std::size_t> blocks_reached(std::size_t block,
                                        const std::vector<std::vector<std::size_t>>& blocks,
                                        const std::vector<std::vector<bool>>& drives, bool rows);

} // namespace resonform
