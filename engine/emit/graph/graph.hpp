// SPDX-License-Identifier: GPL-3.0-or-later
// A hash-consed expression graph: equal expressions are one node; ids are in topological order.
//
//   s = root(xi^2 + r^2, 8);  s * power(s, -14)   ->   (xi^2 + r^2)^-2 * root(.., 4) * root(.., 8)
//
// Exact numbers are folded, sums and products are flat and sorted, equal terms and factors collected.
// A root of even index is a square root of the root of half the index, and its powers are reduced below
// the index, so that every power of a fine root is a short product of shared square roots.
#pragma once

#include "algebra/number/number.hpp"
#include "algebra/number/piecewise_polynomial.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace resonform {

class Graph {
public:
    using Node = int;
    enum class Op {
        rational, // value
        symbol,   // name
        add,      // n-ary
        multiply, // n-ary
        power,    // operand ^ integer (negative allowed)
        root,     // positive real k-th root, k >= 2
        sin,
        cos,
        log,
        log1p, // log(1 + x)
        exp,
        expm1, // e^x - 1
        asinh,
        sinh,
        erf,
        atan2,            // (y, x)
        sqrt_sum_squares, // hypot(a, b)
        spline,           // derivative of data
        callable,         // derivative of a function that is given to emitted code
        doubled           // its operand, computed in twice the digits
    };
    struct Entry {
        Op op = Op::rational;
        Rational value;   // rational
        std::string name; // symbol, callable
        int exponent = 0; // power: exponent; root: k; spline, callable: how often it is differentiated
        DataPointer data; // spline
        std::vector<Node> operands;
    };

    [[nodiscard]] const Entry& at(Node n) const { return entries_[static_cast<std::size_t>(n)]; }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    [[nodiscard]] bool is_rational(Node n, const Rational& value) const;

    Node rational(const Rational& value);
    Node symbol(const std::string& name);
    Node add(std::vector<Node> operands); // flattens, folds rationals, collects equal terms
    // A difference that is small beside its own terms, and meets a small one: it stays one term of the sums
    // to which it is added, and is computed in twice the digits if a term is rounded. No symbol in it may
    // vary.
    //   d = difference(c - s/(k + s));  add({e, d})   ->   e + doubled(c - s/(k + s)),  not (c + e) - s/(k +
    //   s)
    Node difference(Node sum);
    [[nodiscard]] bool stays_one_term(Node n) const { return whole_.contains(n); }
    Node
    multiply(const std::vector<Node>& operands); // flattens, folds rationals, collects equal bases; 0 absorbs
    Node negate(Node n) { return multiply({rational(-1), n}); }
    // Errors: refused: zero to a negative power.
    Node power(Node base, int exponent);
    // A rational with an exact root is folded. Errors: refused: a negative number under the root.
    Node root(Node base, int k);
    // One of sin ... sqrt_sum_squares; exact values at 0 and 1 are folded, log(1 + u) is log1p(u).
    Node function(Op op, std::vector<Node> operands);
    Node spline(DataPointer data, int derivative, Node x);
    Node callable(const std::string& name, int derivative, Node x);

private:
    using Factors = std::map<Node, int>; // base -> exponent
    void collect(Node n, int exponent, Factors& factors, Rational& coefficient);
    void reduce_roots(Factors& factors, Rational& coefficient);
    Node product(const Factors& factors, const Rational& coefficient);
    Node intern_power(Node base, int exponent);
    std::pair<Rational, Node> split_coefficient(Node n);
    std::optional<Node> beside_one(Node n);
    [[nodiscard]] bool is_exact_term(Node n) const;
    [[nodiscard]] bool can_be_doubled(Node n) const;
    Node intern(Entry entry);

    std::vector<Entry> entries_;
    std::set<Node> whole_;
    std::unordered_map<std::string, Node> index_; // keyed by a canonical spelling of the entry
};

// "sin", "hypot": of a function of one variable or two, in formulas as in C++.
const char* function_name(Graph::Op op);

} // namespace resonform
