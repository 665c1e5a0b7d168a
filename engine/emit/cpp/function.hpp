// SPDX-License-Identifier: GPL-3.0-or-later
// Instructions -> the statements of one C++ function. A value used once is written in place, a
// shared or named value gets a statement; long functions are cut into pieces of bounded size.
#pragma once

#include "emit/cpp/lies.hpp"
#include "emit/cpp/names.hpp"
#include "emit/cpp/walk.hpp"
#include "emit/program/straight_line.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// Of the function that computes a doubled value from its symbols.
std::string cpp_difference_name(const StraightLine& code, StraightLine::Value doubled);

class CppFunction {
public:
    // type: the number type of its statements; prefix: of names for nameless values; lies: where its
    // coefficients are to be planted, if they are.
    CppFunction(const StraightLine& code, std::string type, std::string prefix, CppLies* lies = nullptr)
        : code_(&code), type_(std::move(type)), prefix_(std::move(prefix)), lies_(lies) {}

    // A value that need not be computed: `text` stands for it.
    void know(StraightLine::Value v, const std::string& text) { texts_[v] = {text, Level::atom}; }
    // The same, with a name like this one, which is returned.
    std::string know_as(StraightLine::Value v, const std::string& wish) {
        std::string name = names_.unique(wish);
        know(v, name);
        return name;
    }
    // A value computed by `expression`, as a statement of the name `wish`, if something uses it.
    void define(StraightLine::Value v, const std::string& wish, const std::string& expression) {
        given_[v] = {wish, expression};
    }
    // A value to be assigned to `target`, not declared here.
    void assign(StraightLine::Value v, const std::string& target) { targets_[v] = target; }

    // A statement before all others.
    void begin_with(const std::string& target, const std::string& expression) {
        statements_.insert(statements_.begin(), {target, expression, false});
    }
    // Values to be assigned to the elements of an array, in this order.
    void assign(const std::vector<StraightLine::Value>& list, const std::string& array);
    // Too long for statements: a loop walks it, if there are neither data nor callables; at first to some of
    // the roots.
    void walk(std::vector<StraightLine::Value> first = {}) {
        may_walk_ = true;
        first_ = std::move(first);
    }
    [[nodiscard]] bool is_walked() const { return walk_.has_value(); }
    // Callables are members of `object`.
    void call_through(const std::string& object) { callables_in_ = object; }

    // Writes the statements for the roots and all they need.
    void compute(const std::vector<StraightLine::Value>& roots, bool through_constants);
    // How a root is written after compute().
    [[nodiscard]] const std::string& text(StraightLine::Value v) const { return texts_.at(v).text; }

    // The function `result name(parameters)`: its statements, then `last` (lines). With many statements,
    // local quantities become members of a struct and the pieces functions before it.
    using Parameters = std::vector<std::pair<std::string, std::string>>; // type, name
    struct Frame {
        std::string head;         // "template <class Number> static"
        std::string result, name; // "Status", "outputs"
        Parameters parameters;
        std::vector<std::string> first, last; // lines around the statements
    };
    [[nodiscard]] std::string print(const Frame& frame) const;
    // Of a function that is walked: another one, whose statements walk to what comes first and no further.
    [[nodiscard]] std::string print_first(const Frame& frame, const std::string& walked) const;

private:
    enum class Level { sum, product, atom };
    struct Text {
        std::string text;
        Level level = Level::atom;
    };
    struct Statement {
        std::string target, expression;
        bool declared = true;
    };

    static std::string text_of(const std::string& head, const Parameters& parameters,
                               const std::string& body);
    bool walk(const std::vector<StraightLine::Value>& order, const std::vector<StraightLine::Value>& roots);
    void compute_one(StraightLine::Value v, int uses);
    [[nodiscard]] Text expression(StraightLine::Value v) const;
    [[nodiscard]] Text doubled(StraightLine::Value v) const;
    [[nodiscard]] Text sum_of(const StraightLine::Instruction& i) const;
    [[nodiscard]] Text product_of(const StraightLine::Instruction& i) const;
    [[nodiscard]] Text function_of(const StraightLine::Instruction& i) const;
    [[nodiscard]] std::string operand(StraightLine::Value v, Level least) const;
    [[nodiscard]] Text number(const Rational& value) const;
    [[nodiscard]] bool is_coefficient(StraightLine::Value v) const;
    [[nodiscard]] bool begins_with_number(StraightLine::Value v) const;
    [[nodiscard]] std::string planted(const std::string& text) const;
    [[nodiscard]] std::string statement_lines(std::size_t begin, std::size_t end,
                                              const std::set<std::string>& passed_on) const;
    [[nodiscard]] std::set<std::string> passed_on(const std::vector<std::string>& last) const;
    [[nodiscard]] std::string walking(const Frame& frame) const;
    [[nodiscard]] std::string walk_call(const std::string& function, const Parameters& parameters,
                                        std::size_t texts) const;
    [[nodiscard]] Parameters inputs_of_walk(Parameters parameters) const;
    [[nodiscard]] std::string copies_of_walk() const;
    [[nodiscard]] std::string quantities(const std::string& name, bool is_template,
                                         const std::set<std::string>& passed_on) const;

    const StraightLine* code_;
    std::string type_, prefix_;
    CppLies* lies_;
    std::string callables_in_ = "c";
    CppNames names_;
    bool in_pieces_ = false, may_walk_ = false;
    std::vector<StraightLine::Value> first_;
    std::optional<CppWalk> walk_;
    std::vector<std::pair<std::vector<StraightLine::Value>, std::string>> lists_; // and the arrays for them
    std::map<StraightLine::Value, Text> texts_;
    std::map<StraightLine::Value, std::pair<std::string, std::string>> given_;
    std::map<StraightLine::Value, std::string> targets_;
    std::vector<Statement> statements_;
};

} // namespace resonform
