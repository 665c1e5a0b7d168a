// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/block_order.hpp"

#include <algorithm>

namespace resonform {

std::vector<std::size_t> blocks_reached(std::size_t block,
                                        const std::vector<std::vector<std::size_t>>& blocks,
                                        const std::vector<std::vector<bool>>& drives, bool rows) {
    const auto leads = [&](std::size_t from, std::size_t to) {
        const std::size_t t = blocks[from].front(), s = blocks[to].front();
        return from != to && (rows ? drives[s][t] : drives[t][s]);
    };
    std::vector<std::size_t> next;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (leads(block, b)) next.push_back(b);
    std::stable_sort(next.begin(), next.end(), [&](std::size_t p, std::size_t q) {
        const auto before = [&](std::size_t b) {
            return std::count_if(next.begin(), next.end(), [&](std::size_t c) { return leads(c, b); });
        };
        return before(p) < before(q);
    });
    return next;
}

} // namespace resonform
