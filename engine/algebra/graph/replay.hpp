// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of a few coefficients of a graph: the nodes that they need, in order, for any kind of numbers.
//
//   GraphReplay replay(graph, {c});   replay.evaluate<double>(leaf, to_double) = {value of c}
//   ModularReplay modular(replay, field);   16 points at a time, 2 to 3 ns for a term and point
//
// Nothing of the graph's own points and values is used.
#pragma once

#include "algebra/graph/coefficient_graph.hpp"
#include "algebra/number/modular.hpp"

#include <optional>
#include <vector>

namespace resonform {

class GraphReplay {
public:
    struct Step {
        CoefficientGraph::Kind kind;
        std::uint32_t index;      // leaf: LeafId; inverse: the step of its divisor
        std::uint32_t begin, end; // terms of a sum; none: the number 1
        bool minus = false;       // inverse: of the negative of that step
    };
    struct Target {
        std::uint32_t factor, step;
        bool zero;
    };

    GraphReplay(const CoefficientGraph& graph, const std::vector<Coefficient>& wanted);

    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    [[nodiscard]] const std::vector<GraphTerm>& terms() const { return terms_; }    // nodes are steps
    [[nodiscard]] const std::vector<Rational>& factors() const { return factors_; } // the first is 1
    [[nodiscard]] const std::vector<Target>& targets() const { return targets_; }
    [[nodiscard]] const std::vector<LeafId>& leaves() const { return leaves_; } // ascending
    // Inverse steps and the divisors of the graph that they belong to.
    [[nodiscard]] const std::vector<std::pair<std::uint32_t, std::size_t>>& inverses() const {
        return inverses_;
    }

    // leaf(id) and number(rational) give values; nullopt where a divisor is zero.
    template <class Number, class Leaf, class Convert>
    [[nodiscard]] std::optional<std::vector<Number>> evaluate(Leaf leaf, Convert number) const;

private:
    std::vector<Step> steps_;
    std::vector<GraphTerm> terms_;
    std::vector<Rational> factors_;
    std::vector<Target> targets_;
    std::vector<LeafId> leaves_;
    std::vector<std::pair<std::uint32_t, std::size_t>> inverses_;
};

// Modulo one prime, in blocks.
class ModularReplay {
public:
    static constexpr std::size_t block = 16;
    using Block = std::array<Residue, block>;

    // Errors (std::domain_error): the prime divides the denominator of a number.
    ModularReplay(const GraphReplay& replay, const PrimeField& field);

    // points[k]: the values of leaf replay.leaves()[k]. One block for each target; nullopt where a divisor is
    // zero at one of the points.
    [[nodiscard]] std::optional<std::vector<Block>> evaluate(const std::vector<Block>& points);
    // Of the last evaluation, in Montgomery's form.
    [[nodiscard]] const Block& value(std::uint32_t step) const { return values_[step]; }
    [[nodiscard]] const Montgomery& form() const { return form_; }
    [[nodiscard]] const PrimeField& field() const { return field_; }

private:
    void sum(const GraphReplay::Step& step, Block& result) const;
    [[nodiscard]] bool invert(const Block& values, Block& result) const;

    const GraphReplay* replay_;
    PrimeField field_;
    Montgomery form_;
    std::vector<Residue> factors_; // in Montgomery's form, as are the values
    std::vector<Block> values_;
};

template <class Number, class Leaf, class Convert>
std::optional<std::vector<Number>> GraphReplay::evaluate(Leaf leaf, Convert number) const {
    std::vector<Number> factors, values, results;
    for (const Rational& factor : factors_) factors.push_back(number(factor));
    const Number zero = number(Rational(0)), one = number(Rational(1));
    for (const Step& step : steps_) {
        Number value = zero;
        switch (step.kind) {
        case CoefficientGraph::Kind::leaf: value = leaf(step.index); break;
        case CoefficientGraph::Kind::inverse:
            if (values[step.index] == zero) return std::nullopt;
            value = (step.minus ? -one : one) / values[step.index];
            break;
        case CoefficientGraph::Kind::sum:
            if (step.begin == step.end) value = one;
            for (std::uint32_t k = step.begin; k < step.end; ++k)
                value = value + factors[terms_[k].factor] * values[terms_[k].left] * values[terms_[k].right];
        }
        values.push_back(value);
    }
    for (const Target& t : targets_) results.push_back(t.zero ? zero : factors[t.factor] * values[t.step]);
    return results;
}

} // namespace resonform
