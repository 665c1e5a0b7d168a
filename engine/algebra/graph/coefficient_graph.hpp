// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients as nodes of a graph, each value held once: for several symbolic frequencies, where expanded
// quotients explode.
//
//   a, b leaves;  s = a + b;  p = (a - b) s;  q = a a - b b      ->  p and q are one node
//   inverse(6 a - 4 b) = 1/2 * (inverse node of 3 a - 2 b)
//
// A node is a leaf, the inverse of a primitive polynomial in leaves, or a sum of (number)(node)(node). A
// coefficient in a form that occurred before is found by its form. Otherwise its values decide, at three
// random points modulo three different random primes near 2^61: equal values are taken for equal coefficients
// and zeros for zero, both wrong with a probability that GraphBounds computes. The converse is no guess:
// leaves are algebraically independent, so a non-zero residue proves that a coefficient is not identically
// zero. Leaves that are not independent (a root of another leaf, log x and log y and log xy) must not be put
// in.
//
// Signs follow the form, never the residues: the graph is the same for all seeds unless a merge is wrong.
#pragma once

#include "algebra/graph/leaf_polynomial.hpp"
#include "algebra/number/modular.hpp"
#include "algebra/number/rational_table.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace resonform {

using NodeId = std::uint32_t; // operands have smaller ids

// factor * node; zero by default. Two of them are equal exactly when their difference in the graph is zero:
// nodes whose values differ by a number other than -1 are not merged.
struct Coefficient {
    RationalId factor = RationalTable::zero;
    NodeId node = 0;

    [[nodiscard]] bool is_zero() const { return factor == RationalTable::zero; }
    [[nodiscard]] Coefficient negative() const { return {RationalTable::negate(factor), node}; }
    friend bool operator==(const Coefficient&, const Coefficient&) = default;
};

// factor * left * right
struct GraphTerm {
    RationalId factor;
    NodeId left, right;

    friend bool operator==(const GraphTerm&, const GraphTerm&) = default;
};

class CoefficientGraph {
public:
    static constexpr NodeId one_node = 0;
    static constexpr std::size_t points = 3;
    static constexpr std::uint64_t usual_seed = 20;
    using Values = std::array<Residue, points>;
    enum class Kind : std::uint8_t { sum, leaf, inverse };

    explicit CoefficientGraph(std::uint64_t seed = usual_seed);

    // --- making coefficients -------------------------------------------------------------------
    LeafId add_leaf(std::string name);
    [[nodiscard]] Coefficient leaf(LeafId id) const { return {RationalTable::one, leaves_[id].node}; }
    Coefficient number(const Rational& value) { return {rationals_.intern(value), one_node}; }
    Coefficient scaled(RationalId factor, Coefficient a) {
        return {rationals_.multiply(factor, a.factor), factor == RationalTable::zero ? one_node : a.node};
    }
    Coefficient product(Coefficient a, Coefficient b);
    Coefficient sum(Coefficient a, Coefficient b);
    Coefficient power(Coefficient a, int exponent); // exponent >= 0
    Coefficient polynomial(const LeafPolynomial& p);
    Coefficient inverse(const LeafPolynomial& p); // p not zero
    // The sum of the terms, which it overwrites; equal pairs of nodes may occur, zero factors may not.
    Coefficient dot(std::span<GraphTerm> terms);

    // --- reading -------------------------------------------------------------------------------
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    [[nodiscard]] std::size_t terms() const { return terms_.size(); }
    [[nodiscard]] Kind kind(NodeId node) const { return nodes_[node].kind; }
    [[nodiscard]] std::span<const GraphTerm> terms_of(NodeId node) const;                  // of a sum
    [[nodiscard]] std::uint32_t index_of(NodeId node) const { return nodes_[node].index; } // leaf, divisor
    [[nodiscard]] std::size_t leaves() const { return leaves_.size(); }
    [[nodiscard]] const std::string& leaf_name(LeafId id) const { return leaves_[id].name; }
    [[nodiscard]] std::size_t divisors() const { return divisors_.size(); }
    [[nodiscard]] const LeafPolynomial& divisor(std::size_t index) const { return divisors_[index].value; }
    // The node of the divisor itself.
    [[nodiscard]] Coefficient divisor_value(std::size_t index) const { return divisors_[index].coefficient; }
    [[nodiscard]] NodeId divisor_inverse(std::size_t index) const { return divisors_[index].inverse; }
    [[nodiscard]] RationalTable& rationals() { return rationals_; }
    [[nodiscard]] const RationalTable& rationals() const { return rationals_; }

    // Counts of the decisions by values, for the probability that one of them is wrong.
    struct Decisions {
        std::size_t asked = 0;  // comparisons of a new form with all nodes and zero
        std::size_t merged = 0; // forms that a node of another form stands for
        std::size_t zeros = 0;  // forms that vanish
    };
    [[nodiscard]] const Decisions& decisions() const { return decisions_; }
    [[nodiscard]] const PrimeField& field(std::size_t point) const { return fields_[point]; }

private:
    struct Node {
        Kind kind;
        std::uint32_t index; // sum: form; leaf; inverse: divisor
    };
    // A form that occurred and the coefficient that has its value: a node's own, an alias, or zero.
    struct Form {
        std::uint32_t begin, count;
        std::uint32_t hash;
        Coefficient meaning;
    };
    struct Leaf {
        std::string name;
        NodeId node;
    };
    struct Divisor {
        LeafPolynomial value;
        Coefficient coefficient;
        NodeId inverse;
    };

    [[nodiscard]] std::span<GraphTerm> collected(std::span<GraphTerm> terms);
    Coefficient lookup(std::span<const GraphTerm> form);
    Coefficient decide(std::span<const GraphTerm> form);
    [[nodiscard]] Values values_of(std::span<const GraphTerm> form);
    [[nodiscard]] Residue residue(RationalId id, std::size_t point);
    NodeId append(Kind kind, std::uint32_t index, const Values& values);
    std::uint32_t& slot_of_values(const Values& values);
    void grow_forms();
    void grow_values();
    [[nodiscard]] Values negated(Values values) const;

    std::mt19937_64 random_;
    std::vector<PrimeField> fields_;
    RationalTable rationals_;
    std::vector<Values> residues_; // of rationals, by id
    std::vector<Node> nodes_;
    std::vector<Values> values_; // of nodes
    std::vector<GraphTerm> terms_;
    std::vector<Form> forms_;
    std::vector<std::uint32_t> form_slots_, value_slots_; // number plus one; 0: free
    std::vector<Leaf> leaves_;
    std::vector<Divisor> divisors_;
    std::map<LeafPolynomial, std::size_t> known_divisors_;
    Decisions decisions_;
};

} // namespace resonform
