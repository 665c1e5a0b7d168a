// SPDX-License-Identifier: GPL-3.0-or-later
// Places of values in an array, which are used again when nothing needs their values any more.
#pragma once

#include <cstddef>
#include <set>

namespace resonform {

class ReusedPlaces {
public:
    // taken: so many at the beginning are taken for good.
    explicit ReusedPlaces(std::size_t taken = 0) : used_(taken) {}

    // The lowest that is free.
    std::size_t take() {
        if (free_.empty()) return used_++;
        return free_.extract(free_.begin()).value();
    }
    void give_back(std::size_t place) { free_.insert(place); }
    // How many there are in all.
    [[nodiscard]] std::size_t used() const { return used_; }

private:
    std::set<std::size_t> free_;
    std::size_t used_;
};

} // namespace resonform
