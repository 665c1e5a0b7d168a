// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/straight_line.hpp"

#include "emit/program/prune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace resonform {

namespace {

std::string spelling(const StraightLine::Instruction& i) {
    std::string key = fmt::format("{}|{}|{}|{}|{}|", static_cast<int>(i.op), static_cast<int>(i.function),
                                  i.index, i.symbol, i.negative);
    if (i.op == StraightLine::Op::number) key += to_string(i.number);
    if (i.data != nullptr) key += i.data->name + '|';
    if (!i.callable.empty()) key += i.callable + '|';
    for (const StraightLine::Value v : i.operands) key += fmt::format("{},", v);
    return key;
}

} // namespace

StraightLine::StraightLine(const Program& program) : graph_(program.graph) {
    varying_symbols_.resize(graph_.size(), false);
    for (const Graph::Node n : varying_symbols(program)) varying_symbols_[static_cast<std::size_t>(n)] = true;
    for (const ProgramOutput& named : program.names) names_.emplace(named.value, named.name);
    for (std::size_t n = 0; n < graph_.size(); ++n)
        if (const Graph::Entry& e = graph_.at(static_cast<Graph::Node>(n)); e.op == Graph::Op::power)
            powers_.emplace(e.operands.front(), e.exponent);
}

bool StraightLine::any_varying(const std::vector<Value>& operands) const {
    return std::any_of(operands.begin(), operands.end(), [&](Value v) { return at(v).varying; });
}

StraightLine::Value StraightLine::append(Instruction instruction) {
    if (instruction.op != Op::symbol) instruction.varying = any_varying(instruction.operands);
    const auto [position, fresh] =
        index_.try_emplace(spelling(instruction), static_cast<Value>(instructions_.size()));
    if (fresh) instructions_.push_back(std::move(instruction));
    return position->second;
}

StraightLine::Value StraightLine::lower(Graph::Node n) {
    if (const auto known = lowered_.find(n); known != lowered_.end()) return known->second;
    const Graph::Entry e = graph_.at(n); // a copy: the graph grows
    Instruction i;
    Value value = -1;
    switch (e.op) {
    case Graph::Op::rational: value = number(e.value); break;
    case Graph::Op::symbol:
        i.op = Op::symbol;
        i.symbol = n;
        i.varying = varying_symbols_[static_cast<std::size_t>(n)];
        value = append(std::move(i));
        break;
    case Graph::Op::add: value = add(e); break;
    case Graph::Op::multiply: value = multiply(e); break;
    case Graph::Op::power: value = power(e.operands.front(), e.exponent); break;
    case Graph::Op::doubled:
        i.op = Op::doubled;
        i.operands = {lower(e.operands.front())};
        value = append(std::move(i));
        doubled_.emplace(value, symbols_behind(value));
        break;
    case Graph::Op::root:
        i.op = Op::root;
        i.index = e.exponent;
        i.operands = {lower(e.operands.front())};
        value = append(std::move(i));
        break;
    default:
        i.op = Op::function;
        i.function = e.op;
        i.index = e.exponent;
        i.data = e.data;
        if (e.op == Graph::Op::callable) i.callable = e.name;
        for (const Graph::Node operand : e.operands) i.operands.push_back(lower(operand));
        value = append(std::move(i));
    }
    if (const auto name = names_.find(n); name != names_.end())
        instructions_[static_cast<std::size_t>(value)].label = name->second;
    lowered_.emplace(n, value);
    return value;
}

StraightLine::Value StraightLine::add(const Graph::Entry& e) {
    std::vector<Value> plus, minus;
    for (const Graph::Node operand : e.operands) {
        const Graph::Entry& term = graph_.at(operand);
        const Graph::Entry& first = term.op == Graph::Op::multiply ? graph_.at(term.operands.front()) : term;
        const bool negative = first.op == Graph::Op::rational && first.value < 0;
        if (negative)
            minus.push_back(lower(graph_.negate(operand)));
        else
            plus.push_back(lower(operand));
    }
    return sum(std::move(plus), std::move(minus));
}

StraightLine::Value StraightLine::number(const Rational& value) {
    Instruction i;
    i.number = value;
    return append(std::move(i));
}

StraightLine::Value StraightLine::sum(std::vector<Value> plus, std::vector<Value> minus) {
    gather_constants(plus, minus);
    if (plus.size() == 1 && minus.empty()) return plus.front();
    Instruction i;
    i.op = Op::add;
    i.operands = plus;
    i.operands.insert(i.operands.end(), minus.begin(), minus.end());
    i.negative = minus.size();
    return append(std::move(i));
}

// The constants among varying terms become one constant.
void StraightLine::gather_constants(std::vector<Value>& plus, std::vector<Value>& minus) {
    const auto first_constant = [this](std::vector<Value>& side) {
        return std::stable_partition(side.begin(), side.end(), [&](Value v) { return at(v).varying; });
    };
    const auto p = first_constant(plus), m = first_constant(minus);
    const bool varying = p != plus.begin() || m != minus.begin();
    if (!varying || (plus.end() - p) + (minus.end() - m) < 2) return;
    Instruction gathered;
    gathered.op = Op::add;
    gathered.operands.assign(p, plus.end());
    gathered.operands.insert(gathered.operands.end(), m, minus.end());
    gathered.negative = static_cast<std::size_t>(minus.end() - m);
    plus.erase(p, plus.end());
    minus.erase(m, minus.end());
    plus.push_back(append(std::move(gathered)));
}

// n as a rational power of its innermost radicand: sqrt(sqrt(s)) = s^(1/4).
StraightLine::RootPower StraightLine::root_power(Graph::Node n) const {
    Rational exponent = 1;
    for (;; n = graph_.at(n).operands.front()) {
        const Graph::Entry& e = graph_.at(n);
        if (e.op == Graph::Op::power)
            exponent = exponent * e.exponent;
        else if (e.op == Graph::Op::root)
            exponent = exponent / e.exponent;
        else
            return {n, exponent};
    }
}

// Takes the factors out that are powers of one radicand, two or more, and makes them one value each.
std::vector<StraightLine::Value> StraightLine::root_powers(std::vector<Graph::Node>& factors) {
    std::map<Graph::Node, std::vector<Graph::Node>> by_base;
    for (const Graph::Node n : factors) by_base[root_power(n).base].push_back(n);
    std::vector<Value> result;
    for (const auto& [base, powers] : by_base) {
        if (powers.size() < 2) continue;
        Rational exponent = 0;
        std::vector<Value> values;
        for (const Graph::Node n : powers) {
            exponent = exponent + root_power(n).exponent;
            values.push_back(lower(n));
            factors.erase(std::find(factors.begin(), factors.end(), n));
        }
        result.push_back(product(std::move(values)));
        Instruction& power = instructions_[static_cast<std::size_t>(result.back())];
        if (const auto name = names_.find(base); name != names_.end() && power.label.empty())
            power.label = fmt::format("{}_{}{}_{}", name->second, exponent < 0 ? "m" : "p",
                                      to_string(cln::abs(cln::numerator(exponent))),
                                      to_string(Rational(cln::denominator(exponent))));
    }
    return result;
}

StraightLine::Value StraightLine::multiply(const Graph::Entry& e) {
    std::vector<Graph::Node> nodes = e.operands;
    std::vector<Value> factors = root_powers(nodes);
    if (nodes.empty() && factors.size() == 1) return factors.front();
    for (const Graph::Node n : nodes) factors.push_back(lower(n));
    return product(std::move(factors));
}

// The constants among varying factors become one constant.
StraightLine::Value StraightLine::product(std::vector<Value> factors) {
    const auto constants =
        std::stable_partition(factors.begin(), factors.end(), [&](Value v) { return at(v).varying; });
    if (constants != factors.begin() && factors.end() - constants > 1) {
        Instruction gathered;
        gathered.op = Op::multiply;
        gathered.operands.assign(constants, factors.end());
        factors.erase(constants, factors.end());
        factors.push_back(append(std::move(gathered)));
    }
    std::stable_partition(factors.begin(), factors.end(), [&](Value v) { return !at(v).varying; });
    if (factors.size() == 1) return factors.front();
    Instruction i;
    i.op = Op::multiply;
    i.operands = std::move(factors);
    return append(std::move(i));
}

// Of a constant that stands in numerators, too, a negative power is one over that one: their rounding errors
// cancel in products, a^5 (1/a^5) instead of a^5 (1/a)^5.
StraightLine::Value StraightLine::power(Graph::Node base, int exponent) {
    const Value of = lower(base);
    if (exponent < 0 && !at(of).varying && powers_.count({base, -exponent}) > 0)
        return reciprocal(chain(of, -exponent));
    return chain(of, exponent);
}

StraightLine::Value StraightLine::reciprocal(Value of) {
    Instruction i;
    i.op = Op::reciprocal;
    i.operands = {of};
    if (!at(of).label.empty()) i.label = "per_" + at(of).label;
    return append(std::move(i));
}

StraightLine::Value StraightLine::chain(Value base, int exponent) {
    if (exponent < 0) return chain(reciprocal(base), -exponent);
    if (exponent == 1) return base;
    if (exponent % 2 == 1) return product({chain(base, exponent - 1), base});
    const Value half = chain(base, exponent / 2);
    return product({half, half});
}

std::vector<StraightLine::Value> StraightLine::behind(const std::vector<Value>& roots, bool through_constants,
                                                      Operands operands) const {
    std::vector<bool> used(size(), false);
    for (const Value root : roots) used[static_cast<std::size_t>(root)] = true;
    std::vector<Value> result;
    for (std::size_t v = size(); v > 0; --v) {
        if (!used[v - 1]) continue;
        result.push_back(static_cast<Value>(v - 1));
        if (!instructions_[v - 1].varying && !through_constants) continue;
        for (const Value operand : (this->*operands)(static_cast<Value>(v - 1)))
            used[static_cast<std::size_t>(operand)] = true;
    }
    std::reverse(result.begin(), result.end());
    return result;
}

std::vector<StraightLine::Value> StraightLine::behind(const std::vector<Value>& roots,
                                                      bool through_constants) const {
    return behind(roots, through_constants, &StraightLine::operands);
}

std::vector<StraightLine::Value> StraightLine::behind_doubled(const std::vector<Value>& roots,
                                                              bool through_constants) const {
    return behind(roots, through_constants, &StraightLine::sources);
}

const std::vector<StraightLine::Value>& StraightLine::sources(Value v) const {
    return at(v).op == Op::doubled ? doubled_.at(v) : at(v).operands;
}

std::vector<StraightLine::Value> StraightLine::symbols_behind(Value v) const {
    std::vector<Value> symbols = behind({v}, true);
    std::erase_if(symbols, [this](Value below) { return at(below).op != Op::symbol; });
    return symbols;
}

namespace {

// What sums of rows take beside their amplitudes: powers of what turns with each phase, for each harmonic
// products of them, a product and a sum for each row (runtime/rows.hpp).
void count_sums(const Program& program, OperationCount& count) {
    std::set<std::vector<int>> products;
    int highest = 1;
    for (const ProgramRow& row : program.rows)
        for (std::size_t p = 0; p < row.turns.size(); ++p) {
            products.emplace(row.turns.begin(), row.turns.begin() + static_cast<std::ptrdiff_t>(p + 1));
            highest = std::max(highest, std::abs(row.turns[p]));
        }
    const int turns =
        static_cast<int>(products.size()) + static_cast<int>(program.phases.size()) * (highest - 1);
    count.add += 2 * turns + static_cast<int>(program.rows.size());
    count.multiply += 4 * turns + static_cast<int>(program.rows.size());
}

} // namespace

OperationCount count_operations(const Program& program) {
    StraightLine code(program);
    std::vector<StraightLine::Value> roots;
    OperationCount count;
    if (program.sums_rows) {
        for (const ProgramRow& row : program.rows) roots.push_back(code.lower(row.amplitude));
        count_sums(program, count);
    } else {
        for (const ProgramOutput& output : program.outputs) roots.push_back(code.lower(output.value));
    }
    count.tables = static_cast<int>(program.flow.size() + program.tables.size());
    for (const ProgramPhase& phase : program.phases) ++(phase.decays() ? count.other : count.sincos);
    for (const StraightLine::Value v : code.behind(roots, false)) {
        const StraightLine::Instruction& i = code.at(v);
        if (!i.varying) continue;
        const int n = static_cast<int>(i.operands.size());
        switch (i.op) {
        case StraightLine::Op::add: count.add += n - 1; break;
        case StraightLine::Op::multiply: count.multiply += n - 1; break;
        case StraightLine::Op::reciprocal: count.divide += 1; break;
        case StraightLine::Op::root: count.root += 1; break;
        case StraightLine::Op::function: count.other += 1; break;
        case StraightLine::Op::doubled: // a constant
        case StraightLine::Op::number:
        case StraightLine::Op::symbol: break;
        }
    }
    return count;
}

} // namespace resonform
