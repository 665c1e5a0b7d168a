// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace resonform {

namespace {

using Op = StraightLine::Op;
using Value = StraightLine::Value;

constexpr double small = 1e-3;   // eps
constexpr double typical = 0.75; // symbols without a default, cosines and sines

// Of a sum: that of its terms.
double size_by(const StraightLine::Instruction& i, const std::vector<double>& x, double symbol) {
    double size = i.op == Op::multiply ? 1 : 0;
    switch (i.op) {
    case Op::number: return std::fabs(cln::double_approx(i.number));
    case Op::symbol: return symbol;
    case Op::add:
        for (const double term : x) size += term;
        return size;
    case Op::multiply:
        for (const double factor : x) size *= factor;
        return size;
    case Op::reciprocal: return x[0] > 0 ? 1 / x[0] : 1;
    case Op::root: return std::pow(x[0], 1.0 / i.index);
    case Op::doubled: return x[0];
    case Op::function: break;
    }
    return i.function == Graph::Op::sqrt_sum_squares ? std::hypot(x[0], x[1]) : typical;
}

// How many units u a step adds, each independent of the others.
double units_of(const StraightLine::Instruction& i) {
    switch (i.op) {
    case Op::number:
    case Op::symbol: return 0;
    case Op::add:
    case Op::multiply: return static_cast<double>(i.operands.size()) - 1;
    case Op::function: return 2;
    default: return 1;
    }
}

// What is tabulated: start + int_0^T rate(T') dT', for T of about 1. start: -1 if that is 0.
struct Column {
    Value value, start, rate;
};

class Roundings {
public:
    Roundings(const StraightLine& code, Graph::Node eps)
        : code_(code), symbols_{{eps, small}}, sizes_(code.size()) {}

    void set(Graph::Node symbol, double size) { symbols_[symbol] = size; }

    // Start values are taken to be as large as their defaults, or as eps where the default is 0.
    void take(Graph::Node symbol, Value by_default) {
        add({by_default});
        const double size = size_at(by_default);
        symbols_[symbol] = size > 0 ? size : small;
    }

    // Columns of a flow need each other: their rates see what starts them.
    void take_start(const Column& column) {
        if (column.start < 0) return;
        add({column.start});
        set_size(column, size_at(column.start));
    }
    // After those that its rate needs.
    void take(const Column& column) {
        add({column.rate});
        set_size(column, size_of(column));
        columns_.push_back(column);
    }

    void add(const std::vector<Value>& roots) {
        for (const Value v : code_.behind(roots, true)) {
            const StraightLine::Instruction& i = code_.at(v);
            std::vector<double> operands;
            for (const Value operand : i.operands) operands.push_back(size_at(operand));
            const auto known = symbols_.find(i.symbol);
            sizes_[place(v)] = size_by(i, operands, known == symbols_.end() ? typical : known->second);
        }
    }

    // Of an output that has been added; once: each constant is rounded once, whatever it is made of.
    [[nodiscard]] RoundingOfOutput of(Value output) const {
        if (size_at(output) == 0) return {};
        std::vector<double> share(code_.size()); // how far a relative error of a value is one of the output
        share[place(output)] = 1;
        const double calls = pass_down(output, share);
        for (std::size_t k = columns_.size(); k-- > 0;) {
            const Column& column = columns_[k];
            const double all = std::exchange(share[place(column.value)], 0);
            for (const Value part : {column.start, column.rate}) {
                if (all == 0 || part < 0 || size_at(part) == 0) continue;
                share[place(part)] += all * size_at(part) / size_of(column);
                pass_down(part, share); // rounding at single nodes averages out and is not counted
            }
        }
        double stepwise = calls, once = calls;
        const std::vector<double> direct = share;
        for (std::size_t v = code_.size(); v-- > 0;) {
            const StraightLine::Instruction& i = code_.at(static_cast<Value>(v));
            if (i.varying || share[v] == 0) continue;
            once += std::fmin(1, units_of(i)) * direct[v] * direct[v];
            stepwise += units_of(i) * share[v] * share[v];
            pass_on(static_cast<Value>(v), share);
        }
        return {std::sqrt(stepwise), std::sqrt(once)};
    }

private:
    void set_size(const Column& column, double size) {
        if (size > 0) symbols_[code_.at(column.value).symbol] = size;
    }
    static std::size_t place(Value v) { return static_cast<std::size_t>(v); }
    [[nodiscard]] double size_at(Value v) const { return sizes_[place(v)]; }
    [[nodiscard]] double size_of(const Column& column) const {
        return (column.start < 0 ? 0 : size_at(column.start)) + size_at(column.rate);
    }
    // How far a relative error of the operand is one of the value.
    [[nodiscard]] double weight_of(const StraightLine::Instruction& i, Value operand, Value v) const {
        switch (i.op) {
        case Op::add: return size_at(v) > 0 ? size_at(operand) / size_at(v) : 0;
        case Op::root: return 1.0 / i.index;
        case Op::doubled: return 0;
        default: return 1;
        }
    }
    void pass_on(Value v, std::vector<double>& share) const {
        const StraightLine::Instruction& i = code_.at(v);
        for (const Value operand : i.operands)
            share[place(operand)] += share[place(v)] * weight_of(i, operand, v);
    }
    // The shares of varying values go on to constants and symbols; the sum of the squares of their errors.
    double pass_down(Value root, std::vector<double>& share) const {
        double squares = 0;
        const std::vector<Value> steps = code_.behind({root}, false);
        for (std::size_t k = steps.size(); k-- > 0;) {
            const StraightLine::Instruction& i = code_.at(steps[k]);
            if (!i.varying || i.op == Op::symbol) continue;
            squares += units_of(i) * share[place(steps[k])] * share[place(steps[k])];
            pass_on(steps[k], share);
            share[place(steps[k])] = 0;
        }
        return squares;
    }

    const StraightLine& code_;
    std::map<Graph::Node, double> symbols_;
    std::vector<double> sizes_;
    std::vector<Column> columns_;
};

} // namespace

std::vector<RoundingOfOutput> rounding_of_constants(const Program& program, StraightLine& code,
                                                    const std::vector<Value>& outputs) {
    std::vector<std::pair<Graph::Node, Value>> defaults;
    for (const ProgramInput& input : program.start)
        if (input.default_value >= 0) defaults.emplace_back(input.symbol, code.lower(input.default_value));
    std::vector<Column> columns;
    for (const ProgramFlow& flow : program.flow)
        columns.push_back({code.lower(flow.value), code.lower(flow.start), code.lower(flow.rate)});
    for (const ProgramTable& table : program.tables)
        columns.push_back({code.lower(table.value), -1, code.lower(table.integrand)});
    std::vector<RoundingOfOutput> result;
    for (const double left : {typical, 0.0}) {
        Roundings roundings(code, program.eps);
        for (const ProgramPhase& phase : program.phases)
            if (phase.decays()) roundings.set(phase.exponential, left);
        for (const auto& [symbol, value] : defaults) roundings.take(symbol, value);
        for (const Column& column : columns) roundings.take_start(column);
        for (const Column& column : columns) roundings.take(column);
        roundings.add(outputs);
        for (const Value v : outputs) result.push_back(roundings.of(v));
    }
    return result;
}

bool rounds_much(const std::vector<RoundingOfOutput>& roundings) {
    constexpr double much = 5;
    return std::any_of(roundings.begin(), roundings.end(),
                       [](const RoundingOfOutput& r) { return r.stepwise * r.stepwise > much * r.once; });
}

} // namespace resonform
