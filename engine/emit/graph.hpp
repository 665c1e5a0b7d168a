// SPDX-License-Identifier: GPL-3.0-or-later
// A hash-consed expression graph: equal expressions are one node; ids are in topological order.
#pragma once

#include "algebra/number.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
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
        exp,
        atan2,
        sqrt_sum_squares // hypot(a, b)
    };
    struct Entry {
        Op op = Op::rational;
        Rational value;   // rational
        std::string name; // symbol
        int exponent = 0; // power: exponent; root: k
        std::vector<Node> operands;
    };

    [[nodiscard]] const Entry& at(Node n) const { return entries_[static_cast<std::size_t>(n)]; }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }

    Node rational(const Rational& value);
    Node symbol(const std::string& name);
    Node add(std::vector<Node> operands);      // flattens, folds rationals, sorts by id
    Node multiply(std::vector<Node> operands); // same; 0 absorbs
    Node power(Node base, int exponent);
    Node root(Node base, int k);
    Node function(Op op, std::vector<Node> operands);

private:
    Node intern(Entry entry);
    std::vector<Entry> entries_;
    std::map<std::string, Node> index_; // keyed by a canonical spelling of the entry
};

} // namespace resonform
