// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials of a ring -> nodes of a graph, with few operations:
//
//   (16 g^-1 s^-13 r v^2 - ...)   ->   s^-13 (c_1 + xi^2 c_2),   s^-13 = s^3/(s^8)^2
//
// Powers of roots are factored out, the rest is grouped by Horner's rule, first by generators that change
// from call to call, so that the coefficients are constants of the construction, last by those that are
// numbers: where numbers cancel, their sum is formed exactly.
#pragma once

#include "algebra/number/error.hpp"
#include "algebra/ring/ring.hpp"
#include "emit/display/divisor_fractions.hpp"
#include "emit/graph/graph.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace resonform {

// Among the numbers put in.
class DivisionByZero : public Error {
public:
    using Error::Error;
};

class Lowering {
public:
    Lowering(Graph& graph, RingPtr ring) : graph_(&graph), ring_(std::move(ring)) {
        nodes_.resize(static_cast<std::size_t>(ring_->size()), -1);
        change_.resize(nodes_.size(), Change::starts);
    }

    [[nodiscard]] const Ring& ring() const { return *ring_; }

    // The node of a generator; varying: it changes from call to call.
    void define(GeneratorId id, Graph::Node node, bool varying);
    [[nodiscard]] Graph::Node node(GeneratorId id) const { return nodes_[static_cast<std::size_t>(id)]; }
    [[nodiscard]] bool varying(GeneratorId id) const {
        return change_[static_cast<std::size_t>(id)] == Change::calls;
    }

    // Precondition: every generator in p is defined. Errors (refused): DivisionByZero.
    Graph::Node polynomial(const Polynomial& p) { return fractions(reduced_fractions(*ring_, p)); }
    // The same for fractions prepared by reduced_fractions(), when p is lowered at several places.
    Graph::Node fractions(const std::vector<Fraction>& list);
    // The same without looking for common root powers: for radicands, while roots are not yet defined. What a
    // sum is formed from may be far larger than it: constants meet first, and differences of squares are
    // factored (differences.hpp).
    Graph::Node radicand(const Polynomial& p);
    // A divisor, or the radicand of a root. Where it is A + R, R a square root times something, A and R of
    // proved opposite sign, it becomes (A^2 - R^2)/(A - R), whose numerator cancels exactly and whose
    // denominator does not cancel:
    //   sqrt(1 + s^2) - (1 + s^2)   ->   -s^2 (1 + s^2)/(sqrt(1 + s^2) + 1 + s^2)
    // A sum of numbers with different signs is formed exactly:   1 - pi/3 -> -0.0471975...
    // (conditioning.cpp)
    Graph::Node conditioned(const Polynomial& p);
    // The same of a divisor that is no factor of a fraction but a quantity of its own; otherwise as
    // polynomial().
    Graph::Node divisor(const Polynomial& p);
    // 1/x is this node, which is finite where x = 0.
    void set_inverse(Graph::Node x, Graph::Node inverse) { inverses_[x] = inverse; }
    // Nodes known to be positive.
    void set_positive(std::set<Graph::Node> positive) { positive_ = std::move(positive); }

private:
    // The terms of a sum: rows of exponents, one for each generator, in one block.
    struct Terms {
        std::size_t width = 0;
        std::vector<int> exponents;
        std::vector<Rational> coefficients;

        [[nodiscard]] int* row(std::size_t k) { return exponents.data() + k * width; }
        [[nodiscard]] const int* row(std::size_t k) const { return exponents.data() + k * width; }
    };
    using Rows = std::span<std::size_t>; // of the terms
    // From call to call, from start to start; never: a number, as the root of one.
    enum class Change { calls, starts, never };

    void fold(const Monomial& m, Rational coefficient, Terms& terms) const;
    // The rows of different exponents, each with the sum of its coefficients; those of equal powers of
    // `roots` side by side.
    [[nodiscard]] std::vector<std::size_t> collected(Terms& terms,
                                                     const std::vector<std::size_t>& roots) const;
    [[nodiscard]] std::vector<std::size_t> varying_roots() const;
    [[nodiscard]] Graph::Node power(Graph::Node x, int exponent) const;
    std::optional<Graph::Node> without_cancellation(const Polynomial& p);
    // Whether a sum is far smaller than the numbers it is made of; nullopt: it is no sum of numbers alone.
    std::optional<bool> cancels(Graph::Node sum);
    // Such a sum is formed exactly.
    Graph::Node without_lost_digits(Graph::Node sum);
    // Whether a factor is a sum that may be far smaller than its terms: they are no numbers, or 20000 -
    // sqrt(19998)*sqrt(20002). sqrt(k)*(2 - sqrt(2)) loses no more than a digit.
    bool has_cancelling_factor(Graph::Node n);
    // NaN: it has symbols.
    double rough_value(Graph::Node n);
    // The part of a sum in which e^u - 1 is a factor, divided by it, taken out of the sum; nullopt: none.
    struct Divided {
        Graph::Node argument; // u
        Terms terms;
    };
    std::optional<Divided> without_exponential(Terms& terms) const;
    template <class Sum> Graph::Node by_exponentials(Terms& terms, const Sum& sum);
    Graph::Node lowered(Terms& terms);
    Graph::Node by_roots(Terms& terms);
    // is_radicand: the digits of sums count, differences of squares are factored.
    Graph::Node sum_of(Terms& terms, Rows rows, bool is_radicand = false);
    Graph::Node horner(Terms& terms, Rows rows, Change change, bool is_radicand);
    [[nodiscard]] bool is_exponential(std::size_t id) const;
    Graph::Node common_factor(Terms& terms, Rows rows, Change change);
    [[nodiscard]] int most_frequent(const Terms& terms, Rows rows, Change change) const;

    Graph* graph_;
    RingPtr ring_;
    std::vector<Graph::Node> nodes_;
    std::vector<Change> change_;
    std::set<Graph::Node> positive_;
    std::map<Graph::Node, Graph::Node> inverses_;
    std::map<Graph::Node, double> rough_values_; // of nodes without symbols
};

} // namespace resonform
