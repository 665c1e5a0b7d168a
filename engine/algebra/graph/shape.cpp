// SPDX-License-Identifier: GPL-3.0-or-later
// The denominator and the degrees of a coefficient, from its values along lines.
#include "algebra/graph/newton_grid.hpp"
#include "algebra/graph/numerator.hpp"
#include "algebra/number/modular.hpp"

#include <flint/nmod_poly.h>

#include <algorithm>
#include <set>

namespace resonform {

namespace {

using Coefficients = std::vector<Residue>; // of a polynomial in one variable, the constant first

void trim(Coefficients& p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
}

// p/q if q divides p. q is not empty.
std::optional<Coefficients> quotient(const PrimeField& field, const Coefficients& p, const Coefficients& q) {
    if (p.size() < q.size()) return std::nullopt;
    Coefficients result(p.size() - q.size() + 1);
    if (_nmod_poly_divides(result.data(), p.data(), static_cast<slong>(p.size()), q.data(),
                           static_cast<slong>(q.size()), field.modulus()) == 0)
        return std::nullopt;
    return result;
}

// For each step its denominator as the recursion left it, and the degrees of its numerator.
class DegreePass {
public:
    DegreePass(const CoefficientGraph& graph, const GraphReplay& replay, const std::set<LeafId>& inner)
        : graph_(graph), replay_(replay), bounds_(replay.steps().size()) {
        for (std::size_t k = 0; k < bounds_.size(); ++k) {
            Bound& bound = bounds_[k];
            bound.multiplicities.assign(replay.inverses().size(), 0);
            const GraphReplay::Step& step = replay.steps()[k];
            if (step.kind == CoefficientGraph::Kind::leaf) {
                (inner.count(step.index) != 0 ? bound.inner : bound.outer) = 1;
            } else if (step.kind == CoefficientGraph::Kind::inverse) {
                invert(bound, static_cast<std::uint32_t>(k));
            } else {
                add_up(bound, step);
            }
        }
    }

    [[nodiscard]] DivisorPowers denominator(std::uint32_t step) const {
        DivisorPowers powers;
        for (std::size_t k = 0; k < replay_.inverses().size(); ++k)
            if (const int times = bounds_[step].multiplicities[k]; times > 0)
                powers.emplace_back(replay_.inverses()[k].second, times);
        return powers;
    }
    [[nodiscard]] int inner_degree(std::uint32_t step) const {
        int degree = bounds_[step].inner;
        for (const auto& [divisor, times] : denominator(step))
            degree += times * graph_.divisor(divisor).degree();
        return std::max(0, degree);
    }
    [[nodiscard]] int outer_degree(std::uint32_t step) const { return bounds_[step].outer; }

private:
    struct Bound {
        std::vector<int> multiplicities; // of replay.inverses()
        int inner = 0, outer = 0;        // degree above that of the denominator
    };

    void invert(Bound& bound, std::uint32_t step) const {
        for (std::size_t j = 0; j < replay_.inverses().size(); ++j)
            if (replay_.inverses()[j].first == step) {
                bound.multiplicities[j] = 1;
                bound.inner = -graph_.divisor(replay_.inverses()[j].second).degree();
            }
    }

    void add_up(Bound& bound, const GraphReplay::Step& step) const {
        for (std::uint32_t k = step.begin; k < step.end; ++k) {
            const Bound &a = bounds_[replay_.terms()[k].left], &b = bounds_[replay_.terms()[k].right];
            for (std::size_t j = 0; j < bound.multiplicities.size(); ++j)
                bound.multiplicities[j] =
                    std::max(bound.multiplicities[j], a.multiplicities[j] + b.multiplicities[j]);
            bound.inner = k == step.begin ? a.inner + b.inner : std::max(bound.inner, a.inner + b.inner);
            bound.outer = std::max(bound.outer, a.outer + b.outer);
        }
    }

    const CoefficientGraph& graph_;
    const GraphReplay& replay_;
    std::vector<Bound> bounds_;
};

class Probe {
public:
    Probe(const CoefficientGraph& graph, const GraphReplay& replay, std::uint64_t seed)
        : graph_(graph), replay_(replay), random_(seed), values_(replay, PrimeField(random_prime(random_))),
          at_(point()), direction_(point()) {}

    CoefficientShape shape() {
        CoefficientShape shape;
        std::set<LeafId> inner;
        for (const auto& inverse : replay_.inverses())
            for (const auto& term : graph_.divisor(inverse.second).terms())
                for (const auto& power : term.first) inner.insert(power.first);
        for (std::size_t k = 0; k < replay_.leaves().size(); ++k)
            (inner.count(replay_.leaves()[k]) != 0 ? shape.inner : shape.outer).push_back(k);
        const DegreePass degrees(graph_, replay_, inner);
        const std::uint32_t target = replay_.targets().front().step;
        shape.denominator = degrees.denominator(target);

        const std::size_t degree = strip(shape, degrees.inner_degree(target));
        const Coefficients ray = along(shape.denominator, degree, shape.inner, false);
        for (std::size_t k = 0; k < ray.size(); ++k)
            if (ray[k] != 0) shape.parts.push_back(static_cast<int>(k));
        const auto outer = static_cast<std::size_t>(degrees.outer_degree(target));
        const Coefficients couplings = along(shape.denominator, outer, shape.outer, true);
        shape.outer_degree = static_cast<int>(couplings.size()) - 1;
        return shape;
    }

private:
    std::vector<Residue> point() {
        std::vector<Residue> result;
        for (std::size_t k = 0; k < replay_.leaves().size(); ++k)
            result.push_back(values_.field().random_unit(random_));
        return result;
    }

    // Cancels the divisors that divide the numerator. Returns the degree of the numerator left.
    std::size_t strip(CoefficientShape& shape, int bound) {
        Coefficients numerator = along(shape.denominator, static_cast<std::size_t>(bound), shape.inner, true);
        for (auto& [divisor, times] : shape.denominator) {
            const Coefficients factor = divisor_along_line(divisor, shape.inner);
            while (times > 0) {
                const auto rest = quotient(values_.field(), numerator, factor);
                if (!rest) break;
                numerator = *rest;
                --times;
            }
        }
        std::erase_if(shape.denominator, [](const auto& power) { return power.second == 0; });
        return numerator.size() - 1;
    }

    // The moving leaves at t: on a line through the point, or on the ray from the origin.
    [[nodiscard]] std::vector<Residue> moved(const std::vector<std::size_t>& moving, Residue t,
                                             bool line) const {
        const PrimeField& field = values_.field();
        std::vector<Residue> result = at_;
        for (const std::size_t k : moving)
            result[k] =
                line ? field.add(at_[k], field.multiply(t, direction_[k])) : field.multiply(t, at_[k]);
        return result;
    }

    // The numerator over this denominator as a polynomial in t.
    Coefficients along(const DivisorPowers& denominator, std::size_t degree,
                       const std::vector<std::size_t>& moving, bool line) {
        const Residue start = values_.field().random_unit(random_);
        std::vector<std::vector<Residue>> points;
        for (std::size_t k = 0; k <= degree; ++k)
            points.push_back(
                moved(moving, values_.field().add(start, values_.field().from(static_cast<std::int64_t>(k))),
                      line));
        return interpolated(start, values_.at(points, denominator));
    }

    Coefficients divisor_along_line(std::size_t divisor, const std::vector<std::size_t>& moving) {
        const Residue start = values_.field().random_unit(random_);
        Coefficients values;
        for (int k = 0; k <= graph_.divisor(divisor).degree(); ++k)
            values.push_back(
                evaluate(graph_.divisor(divisor), values_.field(), replay_.leaves(),
                         moved(moving, values_.field().add(start, values_.field().from(k)), true)));
        return interpolated(start, std::move(values));
    }

    [[nodiscard]] Coefficients interpolated(Residue start, Coefficients values) const {
        const NewtonGrid grid({{1, static_cast<int>(values.size()) - 1}});
        grid.interpolate(values_.field(), {start}, values);
        trim(values);
        return values;
    }

    const CoefficientGraph& graph_;
    const GraphReplay& replay_;
    std::mt19937_64 random_;
    NumeratorValues values_;
    std::vector<Residue> at_, direction_;
};

} // namespace

CoefficientShape shape_of(const CoefficientGraph& graph, const GraphReplay& replay, std::uint64_t seed) {
    return Probe(graph, replay, seed).shape();
}

} // namespace resonform
