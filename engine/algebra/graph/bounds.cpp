// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

struct NodeBound {
    int inverses = 0;  // r
    int constants = 0; // l
    int excess = 0;    // degree of the numerator - degree of D^r
    double bits = 0;
};

double bits_of(const Rational& q) {
    return static_cast<double>(
        std::max(cln::integer_length(cln::numerator(q)), cln::integer_length(cln::denominator(q))));
}

class BoundPass {
public:
    explicit BoundPass(const CoefficientGraph& graph) : graph_(graph) {
        for (std::size_t k = 0; k < graph.divisors(); ++k) {
            degree_ += graph.divisor(k).degree();
            bits_ += bits_of_divisor(k);
        }
        Integer common = 1;
        for (RationalId id = 2; id < graph.rationals().size(); id += 2)
            common = cln::lcm(common, cln::denominator(graph.rationals().value(id)));
        constant_bits_ = bits_of(common);
        for (NodeId node = 0; node < graph.size(); ++node) nodes_.push_back(of(node));
    }

    [[nodiscard]] GraphBounds result() const {
        int inverses = 0, constants = 0, excess = 0;
        for (const NodeBound& b : nodes_) {
            inverses = std::max(inverses, b.inverses);
            constants = std::max(constants, b.constants);
            excess = std::max(excess, b.excess);
        }
        GraphBounds bounds;
        bounds.degree = inverses * degree_ + std::max(0, excess);
        for (const NodeBound& b : nodes_)
            bounds.bits = std::max(bounds.bits, 1 + raised(b, inverses, constants));
        const double at_point = bounds.degree / 0x1p60;
        const double modulo = bounds.bits / 60 / primes_to_choose_from;
        const double pairs = 2.0 * static_cast<double>(graph_.decisions().asked) *
                             static_cast<double>(graph_.size() + 1); // either sign
        bounds.error_probability = pairs * std::pow(at_point + modulo, CoefficientGraph::points);
        return bounds;
    }

private:
    [[nodiscard]] double bits_of_divisor(std::size_t k) const {
        double bits = 0;
        for (const auto& term : graph_.divisor(k).terms()) bits = std::max(bits, bits_of(term.second));
        return bits + std::log2(static_cast<double>(graph_.divisor(k).terms().size()));
    }

    // Of the numerator over D^inverses L^constants.
    [[nodiscard]] double raised(const NodeBound& b, int inverses, int constants) const {
        return b.bits + (inverses - b.inverses) * bits_ + (constants - b.constants) * constant_bits_;
    }

    [[nodiscard]] NodeBound of(NodeId node) const {
        switch (graph_.kind(node)) {
        case CoefficientGraph::Kind::leaf: return {0, 0, 1, 0};
        case CoefficientGraph::Kind::inverse: {
            // 1/d = (D/d)/D
            const std::size_t k = graph_.index_of(node);
            return {1, 0, -graph_.divisor(k).degree(), bits_ - bits_of_divisor(k)};
        }
        case CoefficientGraph::Kind::sum: break;
        }
        return of_sum(node);
    }

    [[nodiscard]] NodeBound of_sum(NodeId node) const {
        const auto terms = graph_.terms_of(node);
        if (terms.empty()) return {};
        NodeBound sum{0, 0, INT32_MIN, 0};
        for (const GraphTerm& t : terms) {
            const NodeBound p = product(t);
            sum.inverses = std::max(sum.inverses, p.inverses);
            sum.constants = std::max(sum.constants, p.constants);
            sum.excess = std::max(sum.excess, p.excess);
        }
        for (const GraphTerm& t : terms)
            sum.bits = std::max(sum.bits, raised(product(t), sum.inverses, sum.constants));
        sum.bits += std::log2(static_cast<double>(terms.size()));
        return sum;
    }

    [[nodiscard]] NodeBound product(const GraphTerm& t) const {
        const NodeBound &a = nodes_[t.left], &b = nodes_[t.right];
        const Rational& c = graph_.rationals().value(t.factor);
        const bool whole = cln::denominator(c) == 1;
        return {a.inverses + b.inverses, a.constants + b.constants + (whole ? 0 : 1), a.excess + b.excess,
                a.bits + b.bits + (t.factor < 4 ? 0 : bits_of(c) + (whole ? 0 : constant_bits_))};
    }

    const CoefficientGraph& graph_;
    std::vector<NodeBound> nodes_;
    int degree_ = 0;           // of D
    double bits_ = 0;          // of D
    double constant_bits_ = 0; // of L
};

} // namespace

GraphBounds bounds_of(const CoefficientGraph& graph) { return BoundPass(graph).result(); }

} // namespace resonform
