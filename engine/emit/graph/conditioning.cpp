// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/graph/conditioning.hpp"

#include "algebra/number/number.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/function_call.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace resonform {

namespace {

bool varies(const Lowering& lowering, const Ring& ring, const Monomial& m) {
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (ring.exponent(m, id) != 0 && lowering.varying(id)) return true;
    return false;
}

struct RootSplit {
    Polynomial a, r; // a + r
};

// R: the part that is an odd power of the square root of one radicand, A: the rest. All ways.
template <class Wanted>
std::vector<RootSplit> root_splits(const Ring& ring, const Polynomial& sum, const Wanted& wanted) {
    std::vector<RootSplit> splits;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.kind != GeneratorKind::root || g.index % 2 != 0 || !wanted(id)) continue;
        std::vector<Term> odd, even;
        for (const Term& t : sum.terms())
            (ring.exponent(t.monomial, id) == g.index / 2 ? odd : even).push_back(t);
        if (odd.empty() || even.empty()) continue;
        splits.push_back({Polynomial::from_terms(std::move(even)), Polynomial::from_terms(std::move(odd))});
    }
    return splits;
}

// argument = A + R, D = R^2 - A^2.
struct AreaForm {
    Polynomial a, d;
};

std::optional<AreaForm> area_form(const Ring& ring, const Lowering& lowering, const Polynomial& argument) {
    const auto any = [](GeneratorId) { return true; }; // constants of the start may cancel as well
    for (const RootSplit& split : root_splits(ring, argument, any)) {
        const Polynomial d = ring.multiply(split.r, split.r) - ring.multiply(split.a, split.a);
        const bool constant = std::none_of(d.terms().begin(), d.terms().end(),
                                           [&](const Term& t) { return varies(lowering, ring, t.monomial); });
        if (constant && !d.empty()) return AreaForm{split.a, d};
    }
    return std::nullopt;
}

} // namespace

SignSet signs_of(const Graph& graph, Graph::Node n, const std::set<Graph::Node>& positive) {
    if (positive.count(n) > 0) return SignSet::of(1);
    const Graph::Entry& e = graph.at(n);
    const auto operand = [&](std::size_t k) { return signs_of(graph, e.operands[k], positive); };
    switch (e.op) {
    case Graph::Op::rational: return SignSet::of(e.value > 0 ? 1 : e.value == 0 ? 0 : -1);
    case Graph::Op::add:
    case Graph::Op::multiply: {
        SignSet signs = operand(0);
        for (std::size_t k = 1; k < e.operands.size() && signs != SignSet::all(); ++k)
            signs = e.op == Graph::Op::add ? signs + operand(k) : signs * operand(k);
        return signs;
    }
    case Graph::Op::root: { // where it is a number; that its radicand is none below 0 is asked on its own
        const SignSet signs = operand(0);
        return {false, signs.zero, signs.positive};
    }
    case Graph::Op::exp: return SignSet::of(1);
    case Graph::Op::expm1:
    case Graph::Op::log1p:
    case Graph::Op::sinh:
    case Graph::Op::asinh:
    case Graph::Op::erf:
    case Graph::Op::doubled: return operand(0);
    case Graph::Op::power: {
        SignSet signs = e.exponent % 2 == 0 ? operand(0).square() : operand(0);
        signs.zero = signs.zero && e.exponent > 0;
        return signs;
    }
    default: return SignSet::all();
    }
}

Graph::Node lower_logarithm(Graph& graph, const Ring& ring, Lowering& lowering, const Polynomial& argument,
                            const std::set<Graph::Node>& positive) {
    if (const std::optional<AreaForm> area = area_form(ring, lowering, argument)) {
        const Graph::Node d = lowering.polynomial(area->d);
        if (signs_of(graph, d, positive).is_positive()) {
            const Graph::Node scale = graph.root(d, 2);
            const Graph::Node x = graph.multiply({lowering.polynomial(area->a), graph.power(scale, -1)});
            return graph.add(
                {graph.function(Graph::Op::asinh, {x}), graph.function(Graph::Op::log, {scale})});
        }
    }
    return graph.function(Graph::Op::log, {lowering.polynomial(argument)});
}

namespace {

// Of a node without symbols, as a user would write it; nullopt if it has some, or a function that no constant
// under [fix] is translated to.
std::optional<GiNaC::ex> constant_of(const Graph& graph, Graph::Node n) {
    const Graph::Entry& e = graph.at(n);
    if (e.op == Graph::Op::rational) return GiNaC::ex(to_string(e.value), GiNaC::lst{});
    GiNaC::exvector operands;
    for (const Graph::Node operand : e.operands) {
        const auto known = constant_of(graph, operand);
        if (!known) return std::nullopt;
        operands.push_back(*known);
    }
    switch (e.op) {
    case Graph::Op::add: return GiNaC::add(operands);
    case Graph::Op::multiply: return GiNaC::mul(operands);
    case Graph::Op::power: return GiNaC::pow(operands[0], e.exponent);
    case Graph::Op::root: return GiNaC::pow(operands[0], GiNaC::numeric(1, e.exponent));
    case Graph::Op::sin: return GiNaC::sin(operands[0]);
    case Graph::Op::cos: return GiNaC::cos(operands[0]);
    case Graph::Op::log: return GiNaC::log(operands[0]);
    case Graph::Op::log1p: return GiNaC::log(1 + operands[0]);
    case Graph::Op::exp: return GiNaC::exp(operands[0]);
    case Graph::Op::expm1: return GiNaC::exp(operands[0]) - 1;
    case Graph::Op::asinh: return GiNaC::asinh(operands[0]);
    case Graph::Op::sinh: return GiNaC::sinh(operands[0]);
    case Graph::Op::erf: return call(Function::error_function, operands[0]);
    case Graph::Op::atan2:
        if (operands[0].is_zero() && operands[1].is_equal(-1)) return GiNaC::Pi;
        return std::nullopt;
    default: return std::nullopt;
    }
}

// Of a node without symbols, to more digits than any real type has.
std::optional<Rational> value_of_constant(const Graph& graph, Graph::Node n) {
    constexpr int bits = 500;
    const auto constant = constant_of(graph, n);
    if (!constant) return std::nullopt;
    const std::optional<RealBall> value = enclose(*constant, {}, bits);
    if (!value || value->sign() == 0) return std::nullopt;
    return middle(*value);
}

// A sum of numbers with different signs, as its value to more digits than any real type has:
//   1 - pi/3   ->   -0.0471975...
Graph::Node with_all_digits(Graph& graph, Graph::Node n) {
    const std::vector<Graph::Node> operands = graph.at(n).operands;
    if (graph.at(n).op != Graph::Op::add) return n;
    bool above = false, below = false;
    for (const Graph::Node operand : operands) {
        const auto constant = constant_of(graph, operand);
        if (!constant) return n;
        (sign_of_constant(*constant) == ConstantSign::positive ? above : below) = true;
    }
    if (!above || !below) return n;
    const std::optional<Rational> value = value_of_constant(graph, n);
    return value ? graph.rational(*value) : n;
}

} // namespace

std::optional<Graph::Node> Lowering::without_cancellation(const Polynomial& p) {
    const auto known = [&](const Polynomial& part) {
        return !signs_of(*graph_, radicand(part), positive_).negative;
    };
    for (const RootSplit& split : root_splits(*ring_, p, [](GeneratorId) { return true; })) {
        const Polynomial &a = split.a, &r = split.r;
        if (!(known(a) && known(-r)) && !(known(-a) && known(r))) continue;
        const Polynomial over = ring_->multiply(a, a) - ring_->multiply(r, r);
        if (!over.empty()) return graph_->multiply({polynomial(over), graph_->power(radicand(a - r), -1)});
    }
    return std::nullopt;
}

Graph::Node Lowering::conditioned(const Polynomial& p) {
    const std::optional<Graph::Node> rewritten = without_cancellation(p);
    return rewritten ? *rewritten : with_all_digits(*graph_, radicand(p));
}

Graph::Node Lowering::divisor(const Polynomial& p) {
    const Graph::Node plain = polynomial(p);
    if (!has_cancelling_factor(plain)) return plain;
    const std::optional<Graph::Node> rewritten = without_cancellation(p);
    return rewritten ? *rewritten : with_all_digits(*graph_, plain);
}

bool Lowering::has_cancelling_factor(Graph::Node n) {
    const Graph::Entry& e = graph_->at(n);
    if (e.op == Graph::Op::add) return cancels(n).value_or(true);
    if (e.op != Graph::Op::multiply && e.op != Graph::Op::power) return false;
    return std::any_of(e.operands.begin(), e.operands.end(),
                       [this](Graph::Node factor) { return has_cancelling_factor(factor); });
}

Graph::Node Lowering::without_lost_digits(Graph::Node sum) {
    return cancels(sum).value_or(false) ? with_all_digits(*graph_, sum) : sum;
}

std::optional<bool> Lowering::cancels(Graph::Node sum) {
    constexpr double much = 16; // a digit is lost, and more
    const Graph::Entry& e = graph_->at(sum);
    if (e.op != Graph::Op::add) return std::nullopt;
    double total = 0, sizes = 0;
    for (const Graph::Node term : e.operands) {
        const double value = rough_value(term);
        total += value;
        sizes += std::fabs(value);
    }
    if (!std::isfinite(sizes)) return std::nullopt;
    return sizes > much * std::fabs(total);
}

double Lowering::rough_value(Graph::Node n) {
    const auto [place, is_new] = rough_values_.try_emplace(n, std::numeric_limits<double>::quiet_NaN());
    if (!is_new) return place->second;
    const Graph::Entry& e = graph_->at(n);
    double value = place->second;
    switch (e.op) {
    case Graph::Op::rational: value = to_double(e.value); break;
    case Graph::Op::add:
        value = 0;
        for (const Graph::Node operand : e.operands) value += rough_value(operand);
        break;
    case Graph::Op::multiply:
        value = 1;
        for (const Graph::Node operand : e.operands) value *= rough_value(operand);
        break;
    case Graph::Op::power: value = std::pow(rough_value(e.operands.front()), e.exponent); break;
    case Graph::Op::root: value = std::pow(rough_value(e.operands.front()), 1.0 / e.exponent); break;
    default:
        if (const std::optional<Rational> constant = value_of_constant(*graph_, n))
            value = to_double(*constant);
    }
    return rough_values_[n] = value;
}

} // namespace resonform
