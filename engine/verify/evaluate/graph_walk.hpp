// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of a graph as numbers of some real type, computed one by one.
#pragma once

#include "algebra/number/binary_parts.hpp"
#include "emit/graph/graph.hpp"
#include "emit/program/prune.hpp"
#include "runtime/math.hpp"
#include "runtime/scaled.hpp"
#include "runtime/twice.hpp"
#include "verify/evaluate/graph_function.hpp"
#include "verify/run/spline.hpp"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace resonform {

// An exact rational, correctly rounded in double.
template <class Number> Number to_number(const BinaryParts& binary) {
    return math::number<Number>(binary.parts, binary.exponent);
}
template <class Number> Number to_number(const Rational& value) {
    return to_number<Number>(binary_parts(value));
}

// The number for phases; multiprecision, in which nothing is judged, has digits to spare.
template <class Number>
using ReferenceWide = std::conditional_t<(math::digits<Number> > 113), Number, WideNumber<Number>>;

// The number of twice the digits.
template <class Number> struct Doubling {
    using Wide = ReferenceWide<Number>;
    static Wide doubled(const Number& x) { return Wide(x); }
    static Number rounded(const Wide& x) { return Number(x); }
};
template <class Number> struct Doubling<Scaled<Number>> {
    using Wide = Scaled<ReferenceWide<Number>>;
    static Wide doubled(const Scaled<Number>& x) { return {ReferenceWide<Number>(x.mantissa), x.exponent}; }
    static Scaled<Number> rounded(const Wide& x) { return {Number(x.mantissa), x.exponent}; }
};

template <class Number> class GraphWalk {
public:
    // numbers: of the nodes, if they are known; they must outlive it.
    explicit GraphWalk(const Graph& graph, const std::vector<BinaryParts>* numbers = nullptr)
        : graph_(&graph), numbers_(numbers), values_(graph.size(), Number(0)) {}

    // Takes over the constant nodes. The constant factors or terms of a varying node become one number, as in
    // emitted code: together they may fit into Number where each alone does not.
    void keep(const GraphWalk<Scaled<Number>>& constants, const std::vector<bool>& varying) {
        varying_ = varying;
        gathered_.resize(varying.size());
        for (std::size_t n = 0; n < varying.size(); ++n) {
            const auto node = static_cast<Graph::Node>(n);
            if (!varying[n]) {
                values_[n] = constants[node].value();
                continue;
            }
            const Graph::Entry& e = graph_->at(node);
            const bool product = e.op == Graph::Op::multiply;
            Scaled<Number> all(product ? 1 : 0);
            for (const Graph::Node x : e.operands)
                if (!varying[static_cast<std::size_t>(x)])
                    all = product ? all * constants[x] : all + constants[x];
            gathered_[n] = all.value();
        }
    }

    void set(Graph::Node symbol, const Number& value) { values_[static_cast<std::size_t>(symbol)] = value; }
    [[nodiscard]] const Number& operator[](Graph::Node n) const {
        return values_[static_cast<std::size_t>(n)];
    }

    [[nodiscard]] const std::vector<Number>& values() const { return values_; }

    // Computes the nodes listed, operands before their users; symbols keep their values from set().
    void compute(const std::vector<Graph::Node>& nodes) {
        for (const Graph::Node n : nodes)
            if (graph_->at(n).op != Graph::Op::symbol) set(n, value(n, graph_->at(n)));
    }

    // sum of |terms| of each node listed; `bounds` holds that of symbols and of nodes computed before.
    void compute_scale(const std::vector<Graph::Node>& nodes, GraphWalk& bounds) const {
        for (const Graph::Node n : nodes) bounds.set(n, bound(n, bounds));
    }

private:
    [[nodiscard]] Number value(Graph::Node n, const Graph::Entry& e) const {
        using namespace resonform::math;
        const auto x = [&](std::size_t k) -> const Number& { return (*this)[e.operands[k]]; };
        const bool gathered = !varying_.empty() && varying_[static_cast<std::size_t>(n)];
        const auto own = [&](std::size_t k) { // not gathered
            return !gathered || varying_[static_cast<std::size_t>(e.operands[k])];
        };
        Number result =
            gathered ? gathered_[static_cast<std::size_t>(n)] : Number(e.op == Graph::Op::multiply ? 1 : 0);
        switch (e.op) {
        case Graph::Op::symbol: break;
        case Graph::Op::rational:
            return numbers_ == nullptr ? to_number<Number>(e.value)
                                       : to_number<Number>((*numbers_)[static_cast<std::size_t>(n)]);
        case Graph::Op::add:
            for (std::size_t k = 0; k < e.operands.size(); ++k)
                if (own(k)) result = result + x(k);
            break;
        case Graph::Op::multiply:
            for (std::size_t k = 0; k < e.operands.size(); ++k)
                if (own(k)) result = result * x(k);
            break;
        case Graph::Op::power:
            result = power(x(0), e.exponent < 0 ? -e.exponent : e.exponent);
            return e.exponent < 0 ? per(result) : result;
        case Graph::Op::root: return e.exponent == 2 ? Number(sqrt(x(0))) : root(x(0), e.exponent);
        case Graph::Op::spline: return spline(spline_of(*e.data), e.exponent, x(0));
        case Graph::Op::doubled: return doubled(e.operands.front());
        default: return graph_function(e.op, x(0), x(e.operands.size() - 1));
        }
        return result;
    }

    // A node in twice the digits, from the symbols on.
    [[nodiscard]] Number doubled(Graph::Node n) const {
        using Both = Doubling<Number>;
        if constexpr (std::is_same_v<typename Both::Wide, Number>) {
            return (*this)[n];
        } else {
            GraphWalk<typename Both::Wide> walk(*graph_, numbers_);
            const std::vector<bool> needed = reachable(*graph_, {n});
            std::vector<Graph::Node> nodes;
            for (Graph::Node below = 0; below <= n; ++below) {
                if (!needed[static_cast<std::size_t>(below)]) continue;
                nodes.push_back(below);
                if (graph_->at(below).op == Graph::Op::symbol) walk.set(below, Both::doubled((*this)[below]));
            }
            walk.compute(nodes);
            return Both::rounded(walk[n]);
        }
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
    const std::vector<BinaryParts>* numbers_;
    std::vector<Number> values_, gathered_;
    std::vector<bool> varying_; // empty: nothing is gathered
};

} // namespace resonform
