// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/grid.hpp"

#include "algebra/number/error.hpp"
#include "verify/sweep/size.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

double drawn_share(std::uint64_t seed, std::uint64_t number) {
    std::uint64_t z = seed + (number + 1) * 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

SweepGrid::SweepGrid(const std::vector<std::string>& over, std::optional<SweepSample> sample)
    : sample_(sample) {
    for (const std::string& text : over) {
        axes_.emplace_back(text, sample_.has_value());
        const std::string& name = axes_.back().name();
        if (std::any_of(axes_.begin(), axes_.end() - 1, [&](const Axis& a) { return a.name() == name; }))
            bad_input(Reason::command_line,
                      {"each name must be given once", name, "leave out the second", {}});
    }
    for (const Axis& axis : axes_)
        points_ = sample_ ? sample_->count : bounded_product({points_, axis.count()});
    values_.resize(axes_.size());
    for (std::size_t a = 0; a < axes_.size(); ++a)
        for (std::uint64_t i = 0; i < (sample_ ? points_ : axes_[a].count()); ++i)
            values_[a].push_back(sample_ ? axes_[a].drawn(drawn_share(sample_->seed, i * axes_.size() + a))
                                         : axes_[a].value(i));
}

std::vector<std::uint64_t> SweepGrid::shape() const {
    if (sample_) return {points_};
    std::vector<std::uint64_t> lengths;
    for (const Axis& axis : axes_) lengths.push_back(axis.count());
    return lengths;
}

std::vector<double> SweepGrid::point(std::uint64_t i) const {
    std::vector<double> coordinates(axes_.size());
    for (std::size_t a = axes_.size(); a-- > 0;) {
        const std::uint64_t length = values_[a].size();
        coordinates[a] = values_[a][sample_ ? i : i % length];
        i = sample_ ? i : i / length;
    }
    return coordinates;
}

} // namespace resonform
