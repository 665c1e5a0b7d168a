// SPDX-License-Identifier: GPL-3.0-or-later
// A program's graph as instructions of a machine with two stages: constants, computed once, and
// values that change from call to call. Powers are chains of multiplications, negative ones start from one
// shared reciprocal, factors and terms that are constant are gathered into one constant, powers of the
// roots of one radicand into one shared power.
//
//   3/16 C^2 s^-3 cos_theta   ->   once: c = 3/16 C C;   per call: p = 1/s, q = p p p, c q cos_theta
#pragma once

#include "emit/program/program.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

class StraightLine {
public:
    using Value = int; // index of an instruction; operands come before their users
    // doubled: its operand, computed in twice the digits from the symbols on.
    enum class Op { number, symbol, add, multiply, reciprocal, root, function, doubled };
    struct Instruction {
        Op op = Op::number;
        Rational number;                     // number
        Graph::Node symbol = -1;             // symbol
        int index = 0;                       // root; how often data or a callable are differentiated
        Graph::Op function = Graph::Op::sin; // function
        DataPointer data;                    // of a spline
        std::string callable;                // its name
        std::vector<Value> operands;         // of add: the positive ones first
        std::size_t negative = 0;            // add: how many operands at the end are subtracted
        bool varying = false;                // computed at each call
        std::string label;                   // the name of Program::names, or ""
    };

    explicit StraightLine(const Program& program);

    // The value of a node; appends the missing instructions.
    Value lower(Graph::Node n);
    // New values of those that are there.
    Value number(const Rational& value);
    Value product(std::vector<Value> factors);
    Value sum(std::vector<Value> plus, std::vector<Value> minus);

    [[nodiscard]] const Instruction& at(Value v) const { return instructions_[static_cast<std::size_t>(v)]; }
    [[nodiscard]] std::size_t size() const { return instructions_.size(); }
    // The instructions that some values need, ascending; constant operands of varying values are included,
    // their own operands only if through_constants.
    [[nodiscard]] std::vector<Value> behind(const std::vector<Value>& roots, bool through_constants) const;
    // The same, but of a doubled value the symbols it is computed from.
    [[nodiscard]] std::vector<Value> behind_doubled(const std::vector<Value>& roots,
                                                    bool through_constants) const;
    // What a value is computed from; of a doubled one: symbols.
    [[nodiscard]] const std::vector<Value>& sources(Value v) const;
    // The doubled values in the order in which they were lowered, each with its symbols.
    [[nodiscard]] const std::map<Value, std::vector<Value>>& doubled() const { return doubled_; }

private:
    struct RootPower { // base^exponent
        Graph::Node base;
        Rational exponent;
    };
    Value append(Instruction instruction);
    Value add(const Graph::Entry& e);
    Value multiply(const Graph::Entry& e);
    Value power(Graph::Node base, int exponent);
    Value reciprocal(Value of);
    Value chain(Value base, int exponent);
    std::vector<Value> root_powers(std::vector<Graph::Node>& factors);
    [[nodiscard]] RootPower root_power(Graph::Node n) const;
    void gather_constants(std::vector<Value>& plus, std::vector<Value>& minus);
    using Operands = const std::vector<Value>& (StraightLine::*)(Value) const;
    [[nodiscard]] std::vector<Value> behind(const std::vector<Value>& roots, bool through_constants,
                                            Operands operands) const;
    [[nodiscard]] const std::vector<Value>& operands(Value v) const { return at(v).operands; }
    [[nodiscard]] std::vector<Value> symbols_behind(Value v) const;
    [[nodiscard]] bool any_varying(const std::vector<Value>& operands) const;

    Graph graph_;
    std::vector<bool> varying_symbols_;
    std::map<Graph::Node, std::string> names_;
    std::set<std::pair<Graph::Node, int>> powers_; // that occur
    std::map<Graph::Node, Value> lowered_;
    std::map<std::string, Value> index_;
    std::vector<Instruction> instructions_;
    std::map<Value, std::vector<Value>> doubled_;
};

// The operations of one call of the outputs, as emitted.
OperationCount count_operations(const Program& program);

} // namespace resonform
