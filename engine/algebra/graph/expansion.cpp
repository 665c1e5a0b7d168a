// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/expansion.hpp"

#include "algebra/graph/newton_grid.hpp"
#include "algebra/number/elimination.hpp"
#include "algebra/number/error.hpp"
#include "algebra/number/modular.hpp"
#include "algebra/number/rational_reconstruction.hpp"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>

namespace resonform {

namespace {

std::vector<NewtonGrid::Group> groups_of(const CoefficientShape& shape) {
    std::vector<NewtonGrid::Group> groups;
    if (!shape.inner.empty())
        groups.push_back({static_cast<int>(shape.inner.size()) - 1, shape.parts.back()});
    groups.push_back({static_cast<int>(shape.outer.size()), shape.outer_degree});
    return groups;
}

// The inverse of the matrix scale_l^degree_i: from values on rays to homogeneous parts.
std::vector<std::vector<Residue>> separation(const PrimeField& field, const std::vector<Residue>& scales,
                                             const std::vector<int>& degrees) {
    std::vector<std::vector<Residue>> rows(scales.size());
    for (std::size_t l = 0; l < rows.size(); ++l)
        for (const int degree : degrees) rows[l].push_back(field.power(scales[l], degree));
    auto inverse = inverse_rows(std::move(rows), Residue{1}, Residues{field});
    if (!inverse) throw std::domain_error("expand: random scales are dependent");
    return *std::move(inverse);
}

// The numerator modulo primes, one after the other.
class Interpolation {
public:
    Interpolation(const GraphReplay& replay, const CoefficientShape& shape, std::mt19937_64& random)
        : replay_(replay), shape_(shape), grid_(groups_of(shape)), random_(random) {}

    // The coefficients of all parts, part after part.
    std::vector<Residue> modulo(const PrimeField& field) {
        NumeratorValues numerator(replay_, field);
        std::vector<Residue> nodes, scales;
        for (std::size_t k = 0; k < grid_.indices(0).size(); ++k) nodes.push_back(field.random_unit(random_));
        for (std::size_t k = 0; k < shape_.parts.size(); ++k) scales.push_back(field.random_unit(random_));
        std::vector<std::vector<Residue>> on_rays;
        for (const Residue scale : scales)
            on_rays.push_back(numerator.at(points(field, nodes, scale), shape_.denominator));
        const auto matrix = separation(field, scales, shape_.parts);
        std::vector<Residue> result;
        for (const std::vector<Residue>& row : matrix) {
            std::vector<Residue> part(grid_.size(), 0);
            for (std::size_t l = 0; l < row.size(); ++l)
                for (std::size_t k = 0; k < part.size(); ++k)
                    part[k] = field.add(part[k], field.multiply(row[l], on_rays[l][k]));
            grid_.interpolate(field, nodes, part);
            result.insert(result.end(), part.begin(), part.end());
        }
        return result;
    }

    [[nodiscard]] LeafPowers powers(std::size_t index) const {
        const std::vector<int>& indices = grid_.indices(index % grid_.size());
        std::map<LeafId, int> powers;
        std::size_t axis = 0;
        int rest = shape_.parts[index / grid_.size()];
        for (std::size_t k = 0; k + 1 < shape_.inner.size(); ++k, ++axis) {
            powers[replay_.leaves()[shape_.inner[k]]] = indices[axis];
            rest -= indices[axis];
        }
        if (rest < 0) throw std::logic_error("expand: a term above its degree");
        if (!shape_.inner.empty()) powers[replay_.leaves()[shape_.inner.back()]] = rest;
        for (const std::size_t k : shape_.outer) powers[replay_.leaves()[k]] = indices[axis++];
        std::erase_if(powers, [](const auto& power) { return power.second == 0; });
        return {powers.begin(), powers.end()};
    }

    [[nodiscard]] std::size_t points() const { return grid_.size() * shape_.parts.size(); }

private:
    // The grid in the outer leaves and, times `scale`, in the inner ones, of which the last is 1.
    [[nodiscard]] std::vector<std::vector<Residue>>
    points(const PrimeField& field, const std::vector<Residue>& nodes, Residue scale) const {
        std::vector<std::vector<Residue>> points(grid_.size(), std::vector<Residue>(replay_.leaves().size()));
        for (std::size_t k = 0; k < grid_.size(); ++k) {
            std::size_t axis = 0;
            const auto coordinate = [&] {
                const Residue value = field.add(nodes[axis], field.from(grid_.indices(k)[axis]));
                ++axis;
                return value;
            };
            for (std::size_t j = 0; j < shape_.inner.size(); ++j)
                points[k][shape_.inner[j]] =
                    j + 1 < shape_.inner.size() ? field.multiply(scale, coordinate()) : scale;
            for (const std::size_t j : shape_.outer) points[k][j] = coordinate();
        }
        return points;
    }

    const GraphReplay& replay_;
    const CoefficientShape& shape_;
    NewtonGrid grid_;
    std::mt19937_64& random_;
};

// Compares values at a rational point, exactly, to catch an evaluator that errs alike for all primes.
void confirm(const CoefficientGraph& graph, const GraphReplay& replay, const ExpandedCoefficient& expanded,
             std::mt19937_64& random) {
    while (true) {
        std::map<LeafId, Rational> point;
        for (const LeafId id : replay.leaves())
            point[id] =
                Rational(static_cast<int>(random() % 199U) + 2) / (static_cast<int>(random() % 13U) + 2);
        const auto number = [](const Rational& q) { return q; };
        const auto value = replay.evaluate<Rational>([&](LeafId id) { return point[id]; }, number);
        if (!value) continue;
        const auto power = [&](LeafId id, int exponent) { return cln::expt(point[id], exponent); };
        Rational product = value->front();
        for (const auto& [divisor, times] : expanded.denominator)
            product = product * cln::expt(graph.divisor(divisor).evaluate<Rational>(power, number), times);
        if (product != expanded.numerator.evaluate<Rational>(power, number))
            throw std::logic_error("expand: the expanded coefficient has another value");
        return;
    }
}

} // namespace

ExpandedCoefficient expand(const CoefficientGraph& graph, Coefficient c, const ExpansionLimits& limits,
                           std::uint64_t seed) {
    ExpandedCoefficient result;
    if (c.is_zero()) return result;
    const GraphReplay replay(graph, {c});
    std::mt19937_64 random(seed);
    const CoefficientShape shape = shape_of(graph, replay, random());
    const double size = NewtonGrid::size_of(groups_of(shape)) * static_cast<double>(shape.parts.size());
    if (size > static_cast<double>(limits.points))
        refuse(Reason::size,
               {fmt::format("a coefficient is written out from its values at up to {} points", limits.points),
                fmt::format("{:.0f} points", size),
                "ask for a lower order, or give parameters numeric values with --set NAME=VALUE",
                {}});
    Interpolation interpolation(replay, shape, random);
    Reconstruction reconstruction;
    std::vector<std::size_t> support; // indices of the coefficients that are not zero modulo the first prime
    std::optional<std::vector<Rational>> numbers;
    while (!numbers) {
        const PrimeField field(random_prime(random));
        const std::vector<Residue> all = interpolation.modulo(field);
        std::vector<Residue> residues;
        if (support.empty())
            for (std::size_t k = 0; k < all.size(); ++k)
                if (all[k] != 0) support.push_back(k);
        for (const std::size_t k : support) residues.push_back(all[k]);
        numbers = reconstruction.add(field, residues);
        ++result.primes;
    }
    for (std::size_t k = 0; k < support.size(); ++k)
        result.numerator.add(interpolation.powers(support[k]), (*numbers)[k]);
    result.denominator = shape.denominator;
    result.points = interpolation.points();
    confirm(graph, replay, result, random);
    return result;
}

} // namespace resonform
