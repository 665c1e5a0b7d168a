// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of a graph as numbers of some real type, computed one by one.
#pragma once

#include "emit/graph.hpp"
#include "runtime/twice.hpp"

#include <cstddef>
#include <vector>

namespace resonform {

// An exact rational, correct to an ulp or two.
template <class Number> Number to_number(const Rational& value) {
    const auto whole = [](Integer n) {
        std::vector<long> chunks; // of 32 bits, the lowest first
        for (; n != 0; n = cln::floor1(n, Integer(1) << 32))
            chunks.push_back(cln::cl_I_to_long(cln::mod(n, Integer(1) << 32)));
        Number result(0);
        for (std::size_t k = chunks.size(); k > 0; --k)
            result = result * Number(4294967296.0) + Number(static_cast<double>(chunks[k - 1]));
        return result;
    };
    const Number size = whole(cln::abs(cln::numerator(value))) / whole(cln::denominator(value));
    return value < 0 ? Number(-size) : size;
}

template <class Number> class GraphWalk {
public:
    explicit GraphWalk(const Graph& graph) : graph_(&graph), values_(graph.size(), Number(0)) {}

    void set(Graph::Node symbol, const Number& value) { values_[static_cast<std::size_t>(symbol)] = value; }
    [[nodiscard]] const Number& operator[](Graph::Node n) const {
        return values_[static_cast<std::size_t>(n)];
    }

    // Computes the nodes listed, operands before their users; symbols keep what was set.
    void compute(const std::vector<Graph::Node>& nodes) {
        for (const Graph::Node n : nodes)
            if (graph_->at(n).op != Graph::Op::symbol) set(n, value(graph_->at(n)));
    }

    // sum of |terms| of each node listed; `bounds` holds that of symbols and of nodes computed before.
    void compute_scale(const std::vector<Graph::Node>& nodes, GraphWalk& bounds) const {
        for (const Graph::Node n : nodes) bounds.set(n, bound(n, bounds));
    }

private:
    [[nodiscard]] Number value(const Graph::Entry& e) const {
        using namespace resonform::math;
        const auto x = [&](std::size_t k) -> const Number& { return (*this)[e.operands[k]]; };
        Number result(e.op == Graph::Op::multiply ? 1 : 0);
        switch (e.op) {
        case Graph::Op::symbol: break;
        case Graph::Op::rational: return to_number<Number>(e.value);
        case Graph::Op::add:
            for (std::size_t k = 0; k < e.operands.size(); ++k) result = result + x(k);
            break;
        case Graph::Op::multiply:
            for (std::size_t k = 0; k < e.operands.size(); ++k) result = result * x(k);
            break;
        case Graph::Op::power:
            result = power(x(0), e.exponent < 0 ? -e.exponent : e.exponent);
            return e.exponent < 0 ? Number(Number(1) / result) : result;
        case Graph::Op::root: return e.exponent == 2 ? Number(sqrt(x(0))) : root(x(0), e.exponent);
        case Graph::Op::sin: return sin(x(0));
        case Graph::Op::cos: return cos(x(0));
        case Graph::Op::log: return log(x(0));
        case Graph::Op::exp: return exp(x(0));
        case Graph::Op::asinh: return asinh(x(0));
        case Graph::Op::atan2: return atan2(x(0), x(1));
        case Graph::Op::sqrt_sum_squares: return hypot(x(0), x(1));
        }
        return result;
    }

    [[nodiscard]] Number bound(Graph::Node n, const GraphWalk& bounds) const {
        const Graph::Entry& e = graph_->at(n);
        Number result(e.op == Graph::Op::multiply ? 1 : 0);
        switch (e.op) {
        case Graph::Op::symbol: return bounds[n];
        case Graph::Op::add:
            for (const Graph::Node operand : e.operands) result = result + bounds[operand];
            return result;
        case Graph::Op::multiply:
            for (const Graph::Node operand : e.operands) result = result * bounds[operand];
            return result;
        case Graph::Op::power:
            if (e.exponent > 0) return math::power(bounds[e.operands.front()], e.exponent);
            break;
        default: break;
        }
        return math::magnitude((*this)[n]);
    }

    const Graph* graph_;
    std::vector<Number> values_;
};

} // namespace resonform
