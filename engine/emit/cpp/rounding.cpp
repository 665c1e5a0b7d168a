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
double size_of(const StraightLine::Instruction& i, const std::vector<double>& x, double symbol) {
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

    void add(const std::vector<Value>& roots) {
        for (const Value v : code_.behind(roots, true)) {
            const StraightLine::Instruction& i = code_.at(v);
            std::vector<double> operands;
            for (const Value operand : i.operands) operands.push_back(size_at(operand));
            const auto known = symbols_.find(i.symbol);
            sizes_[static_cast<std::size_t>(v)] =
                size_of(i, operands, known == symbols_.end() ? typical : known->second);
        }
    }

    // Of an output that has been added; once: each constant is rounded once, whatever it is made of.
    [[nodiscard]] RoundingOfOutput of(Value output) const {
        const std::vector<Value> steps = code_.behind({output}, true);
        std::vector<double> share(code_.size()), of_calls(code_.size());
        share[static_cast<std::size_t>(output)] = of_calls[static_cast<std::size_t>(output)] = 1;
        RoundingOfOutput result;
        if (size_at(output) == 0) return result;
        for (std::size_t k = steps.size(); k-- > 0;) {
            const Value v = steps[k];
            const StraightLine::Instruction& i = code_.at(v);
            const double all = share[static_cast<std::size_t>(v)],
                         own = of_calls[static_cast<std::size_t>(v)];
            const double units = units_of(i);
            result.stepwise += units * all * all;
            result.once += (i.varying ? units : std::fmin(1, units)) * own * own;
            for (const Value operand : i.operands) {
                const double weight = weight_of(i, operand, v);
                share[static_cast<std::size_t>(operand)] += all * weight;
                if (i.varying) of_calls[static_cast<std::size_t>(operand)] += own * weight;
            }
        }
        result.stepwise = std::sqrt(result.stepwise);
        result.once = std::sqrt(result.once);
        return result;
    }

private:
    [[nodiscard]] double size_at(Value v) const { return sizes_[static_cast<std::size_t>(v)]; }
    // How far a relative error of the operand is one of the value.
    [[nodiscard]] double weight_of(const StraightLine::Instruction& i, Value operand, Value v) const {
        switch (i.op) {
        case Op::add: return size_at(v) > 0 ? size_at(operand) / size_at(v) : 0;
        case Op::root: return 1.0 / i.index;
        case Op::doubled: return 0;
        default: return 1;
        }
    }

    const StraightLine& code_;
    std::map<Graph::Node, double> symbols_;
    std::vector<double> sizes_;
};

} // namespace

std::vector<RoundingOfOutput> rounding_of_constants(const Program& program, StraightLine& code,
                                                    const std::vector<Value>& outputs) {
    std::vector<std::pair<Graph::Node, Value>> defaults;
    for (const ProgramInput& input : program.start)
        if (input.default_value >= 0) defaults.emplace_back(input.symbol, code.lower(input.default_value));
    std::vector<RoundingOfOutput> result;
    for (const double left : {typical, 0.0}) {
        Roundings roundings(code, program.eps);
        for (const ProgramPhase& phase : program.phases)
            if (phase.decays()) roundings.set(phase.exponential, left);
        for (const auto& [symbol, value] : defaults) roundings.take(symbol, value);
        roundings.add(outputs);
        for (const Value v : outputs) result.push_back(roundings.of(v));
    }
    return result;
}

bool rounds_much(const std::vector<RoundingOfOutput>& roundings) {
    constexpr double much = 3.5, gain = 0.85;
    return std::any_of(roundings.begin(), roundings.end(), [](const RoundingOfOutput& r) {
        return r.stepwise > much && r.once < gain * r.stepwise;
    });
}

} // namespace resonform
