// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which lies are asked at many starts: most are caught at any of them, and the few that are not
// where others like them were.
#pragma once

#include "verify/run/parallel.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace resonform {

class OrderOfStarts {
public:
    explicit OrderOfStarts(std::size_t starts) : order_(starts), ends_(starts) {
        std::iota(order_.begin(), order_.end(), std::size_t(0));
    }

    // Whether is_end(j, ask(j)) holds at some start j with takes(j). The first start is asked alone, later
    // ones at_a_time in parallel. Their answers go to is_end in order and only up to the first that ends, so
    // that the result does not depend on the number of threads.
    template <class Takes, class Ask, class IsEnd>
    bool ends(const Takes& takes, std::size_t at_a_time, const Ask& ask, const IsEnd& is_end) {
        std::size_t most = 1;
        for (std::size_t next = 0; next < order_.size(); most = at_a_time) {
            std::vector<std::size_t> taken; // positions in the order
            for (; next < order_.size() && taken.size() < most; ++next)
                if (takes(order_[next])) taken.push_back(next);
            std::vector<std::decay_t<decltype(ask(std::size_t(0)))>> answers(taken.size());
            in_parallel(taken.size(), [&](std::size_t k) { answers[k] = ask(order_[taken[k]]); });
            for (std::size_t k = 0; k < taken.size(); ++k)
                if (is_end(order_[taken[k]], answers[k])) {
                    move_forward(taken[k]);
                    return true;
                }
        }
        return false;
    }

private:
    void move_forward(std::size_t at) {
        ++ends_[order_[at]];
        for (; at > 0 && ends_[order_[at]] > ends_[order_[at - 1]]; --at)
            std::swap(order_[at], order_[at - 1]);
    }

    std::vector<std::size_t> order_;
    std::vector<std::size_t> ends_; // of each start
};

} // namespace resonform
