// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials of a ring -> nodes of a graph, with few operations:
//
//   (16 g^-1 s^-13 r v^2 - ...)   ->   s^-13 (c_1 + xi^2 c_2),   s^-13 = s^3/(s^8)^2
//
// Powers of roots are factored out, the rest is grouped by Horner's rule, first by what changes from
// call to call, so that the coefficients are constants of the construction.
#pragma once

#include "algebra/error.hpp"
#include "algebra/ring.hpp"
#include "emit/graph.hpp"

#include <map>
#include <vector>

namespace resonform {

// Among the numbers put in.
class DivisionByZero : public Error {
public:
    using Error::Error;
};

class Lowering {
public:
    Lowering(Graph& graph, RingPtr ring) : graph_(&graph), ring_(std::move(ring)) {
        nodes_.resize(static_cast<std::size_t>(ring_->size()), -1);
        varying_.resize(nodes_.size(), false);
    }

    [[nodiscard]] const Ring& ring() const { return *ring_; }

    // What stands for a generator; varying: it changes from call to call.
    void define(GeneratorId id, Graph::Node node, bool varying);
    [[nodiscard]] Graph::Node node(GeneratorId id) const { return nodes_[static_cast<std::size_t>(id)]; }
    [[nodiscard]] bool varying(GeneratorId id) const { return varying_[static_cast<std::size_t>(id)]; }

    // Precondition: every generator in p is defined. Errors (refused): DivisionByZero.
    Graph::Node polynomial(const Polynomial& p);
    // The same without looking for common root powers: for radicands, while roots are not yet defined.
    Graph::Node radicand(const Polynomial& p);

private:
    using Exponents = std::vector<int>;
    using Terms = std::map<Exponents, Rational>;

    void fold(const Monomial& m, Rational coefficient, Terms& terms) const;
    Graph::Node horner(Terms terms, bool varying);
    Graph::Node common_factor(Terms& terms, bool varying);
    int most_frequent(const Terms& terms, bool varying) const;
    Exponents root_powers(const Exponents& exponents) const;

    Graph* graph_;
    RingPtr ring_;
    std::vector<Graph::Node> nodes_;
    std::vector<bool> varying_;
};

} // namespace resonform
