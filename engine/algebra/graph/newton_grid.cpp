// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/newton_grid.hpp"

#include <map>

namespace resonform {

NewtonGrid::NewtonGrid(const std::vector<Group>& groups) {
    std::vector<int> index;
    append(groups, 0, 0, groups.empty() ? 0 : groups[0].degree, index);
    const std::size_t axes = indices_.front().size();
    lines_.resize(axes);
    for (std::size_t axis = 0; axis < axes; ++axis) {
        std::map<std::vector<int>, std::vector<std::uint32_t>> lines;
        for (std::size_t k = 0; k < indices_.size(); ++k) { // ascending: so is the index along the axis
            std::vector<int> others = indices_[k];
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(axis));
            lines[others].push_back(static_cast<std::uint32_t>(k));
        }
        for (auto& line : lines) lines_[axis].push_back(std::move(line.second));
    }
}

// Lexicographic.
void NewtonGrid::append(const std::vector<Group>& groups, std::size_t group, int variable, int left,
                        std::vector<int>& index) {
    if (group == groups.size()) {
        indices_.push_back(index);
        return;
    }
    if (variable == groups[group].variables) {
        const int next = group + 1 < groups.size() ? groups[group + 1].degree : 0;
        append(groups, group + 1, 0, next, index);
        return;
    }
    for (int k = 0; k <= left; ++k) {
        index.push_back(k);
        append(groups, group, variable + 1, left - k, index);
        index.pop_back();
    }
}

double NewtonGrid::size_of(const std::vector<Group>& groups) {
    double size = 1;
    for (const Group& g : groups) // binomial(degree + variables, variables)
        for (int k = 1; k <= g.variables; ++k) size *= static_cast<double>(g.degree + k) / k;
    return size;
}

void NewtonGrid::interpolate(const PrimeField& field, const std::vector<Residue>& nodes,
                             std::vector<Residue>& values) const {
    std::vector<Residue> inverses{0};
    const auto inverse = [&](std::size_t n) {
        while (inverses.size() <= n)
            inverses.push_back(field.inverse(field.from(static_cast<std::int64_t>(inverses.size()))));
        return inverses[n];
    };
    // Coordinates are equidistant: a divided difference over k steps is divided by k.
    for (const auto& lines : lines_)
        for (const auto& line : lines)
            for (std::size_t k = 1; k < line.size(); ++k)
                for (std::size_t i = line.size() - 1; i >= k; --i)
                    values[line[i]] =
                        field.multiply(field.subtract(values[line[i]], values[line[i - 1]]), inverse(k));
    // From sum_k c_k (x - x_0) ... (x - x_{k-1}) to powers of x.
    for (std::size_t axis = 0; axis < lines_.size(); ++axis)
        for (const auto& line : lines_[axis])
            for (std::size_t k = line.size() - 1; k-- > 0;) {
                const Residue node = field.add(nodes[axis], field.from(static_cast<std::int64_t>(k)));
                for (std::size_t i = k; i + 1 < line.size(); ++i)
                    values[line[i]] =
                        field.subtract(values[line[i]], field.multiply(node, values[line[i + 1]]));
            }
}

} // namespace resonform
