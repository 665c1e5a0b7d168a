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
constexpr double of_function = 2;

struct Rounded {
    double size = 0, error = 0; // of a sum: that of its terms; in units of it
};

Rounded sum_of(const std::vector<Rounded>& terms) {
    Rounded sum;
    for (const Rounded& x : terms) {
        sum.size += x.size;
        sum.error += x.size * x.error;
    }
    if (sum.size > 0) sum.error /= sum.size;
    return {sum.size, sum.error + static_cast<double>(terms.size()) - 1};
}

Rounded product_of(const std::vector<Rounded>& factors) {
    Rounded product{1, static_cast<double>(factors.size()) - 1};
    for (const Rounded& x : factors) {
        product.size *= x.size;
        product.error += x.error;
    }
    return product;
}

Rounded step(const StraightLine::Instruction& i, const std::vector<Rounded>& x, double symbol) {
    switch (i.op) {
    case Op::number: return {std::fabs(cln::double_approx(i.number)), 0};
    case Op::symbol: return {symbol, 0};
    case Op::add: return sum_of(x);
    case Op::multiply: return product_of(x);
    case Op::reciprocal: return {x[0].size > 0 ? 1 / x[0].size : 1, x[0].error + 1};
    case Op::root: return {std::pow(x[0].size, 1.0 / i.index), x[0].error / i.index + 1};
    case Op::doubled: return {x[0].size, 1};
    case Op::function: break;
    }
    Rounded result{typical, of_function};
    for (const Rounded& argument : x) result.error = std::max(result.error, of_function + argument.error);
    if (i.function == Graph::Op::sqrt_sum_squares) result.size = std::hypot(x[0].size, x[1].size);
    return result;
}

class Roundings {
public:
    // once: each constant is rounded once, whatever it is made of.
    Roundings(const StraightLine& code, Graph::Node eps, bool once)
        : code_(code), once_(once), symbols_{{eps, small}}, values_(code.size()) {}

    // Start values are taken to be as large as their defaults, or as eps where the default is 0.
    void take(Graph::Node symbol, Value by_default) {
        add({by_default});
        const double size = values_[static_cast<std::size_t>(by_default)].size;
        symbols_[symbol] = size > 0 ? size : small;
    }

    void add(const std::vector<Value>& roots) {
        for (const Value v : code_.behind(roots, true)) {
            const StraightLine::Instruction& i = code_.at(v);
            std::vector<Rounded> operands;
            for (const Value operand : i.operands)
                operands.push_back(values_[static_cast<std::size_t>(operand)]);
            const auto known = symbols_.find(i.symbol);
            Rounded& value = values_[static_cast<std::size_t>(v)];
            value = step(i, operands, known == symbols_.end() ? typical : known->second);
            if (once_ && !i.varying) value.error = std::min(1.0, value.error);
        }
    }

    [[nodiscard]] double error(Value v) const { return values_[static_cast<std::size_t>(v)].error; }

private:
    const StraightLine& code_;
    bool once_;
    std::map<Graph::Node, double> symbols_;
    std::vector<Rounded> values_;
};

} // namespace

double rounding_of_constants(const Program& program, StraightLine& code, const std::vector<Value>& outputs) {
    std::vector<std::pair<Graph::Node, Value>> defaults;
    for (const ProgramInput& input : program.start)
        if (input.default_value >= 0) defaults.emplace_back(input.symbol, code.lower(input.default_value));
    Roundings all(code, program.eps, false), once(code, program.eps, true);
    for (Roundings* roundings : {&all, &once}) {
        for (const auto& [symbol, value] : defaults) roundings->take(symbol, value);
        roundings->add(outputs);
    }
    double worst = 0;
    for (const Value v : outputs) worst = std::max(worst, all.error(v) - once.error(v));
    return worst;
}

} // namespace resonform
