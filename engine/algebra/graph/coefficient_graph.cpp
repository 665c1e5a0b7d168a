// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/coefficient_graph.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace resonform {

namespace {

std::uint64_t pair_of(const GraphTerm& t) { return (std::uint64_t{t.left} << 32) | t.right; }

void negate(std::span<GraphTerm> terms) {
    for (GraphTerm& t : terms) t.factor = RationalTable::negate(t.factor);
}

} // namespace

CoefficientGraph::CoefficientGraph(std::uint64_t seed) : random_(seed) {
    while (fields_.size() < points) {
        const std::uint64_t prime = random_prime(random_);
        const auto same = [&](const PrimeField& field) { return field.prime() == prime; };
        if (std::none_of(fields_.begin(), fields_.end(), same)) fields_.emplace_back(prime);
    }
    append(Kind::sum, 0, {1, 1, 1}); // the number 1: the empty product, without terms
    forms_.push_back({0, 0, 0, {RationalTable::one, one_node}});
}

LeafId CoefficientGraph::add_leaf(std::string name) {
    Values values{};
    for (std::size_t k = 0; k < points; ++k) values[k] = fields_[k].random_unit(random_);
    const auto id = static_cast<LeafId>(leaves_.size());
    leaves_.push_back({std::move(name), append(Kind::leaf, id, values)});
    return id;
}

Coefficient CoefficientGraph::product(Coefficient a, Coefficient b) {
    const RationalId factor = rationals_.multiply(a.factor, b.factor);
    if (factor == RationalTable::zero) return {};
    GraphTerm term{factor, a.node, b.node};
    return dot({&term, 1});
}

Coefficient CoefficientGraph::sum(Coefficient a, Coefficient b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    GraphTerm terms[] = {{a.factor, a.node, one_node}, {b.factor, b.node, one_node}};
    return dot(terms);
}

Coefficient CoefficientGraph::power(Coefficient a, int exponent) {
    Coefficient result = number(1);
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 != 0) result = product(result, a);
        if (exponent > 1) a = product(a, a);
    }
    return result;
}

Coefficient CoefficientGraph::polynomial(const LeafPolynomial& p) {
    std::vector<GraphTerm> terms;
    for (const auto& [powers, coefficient] : p.terms()) {
        Coefficient product = number(coefficient);
        for (const auto& [id, exponent] : powers) product = this->product(product, power(leaf(id), exponent));
        terms.push_back({product.factor, product.node, one_node});
    }
    return dot(terms);
}

Coefficient CoefficientGraph::inverse(const LeafPolynomial& p) {
    if (p.empty()) throw std::logic_error("CoefficientGraph::inverse: of zero");
    const LeafPolynomial::Parts parts = p.parts();
    Coefficient result = number(1 / parts.content);
    const auto divide = [&](const LeafPolynomial& primitive, int times) {
        const auto [known, fresh] = known_divisors_.emplace(primitive, divisors_.size());
        if (fresh) {
            const Coefficient value = polynomial(primitive);
            Values values = values_of(std::array<GraphTerm, 1>{{{value.factor, value.node, one_node}}});
            for (std::size_t k = 0; k < points; ++k) {
                if (values[k] == 0) throw std::logic_error("CoefficientGraph: a divisor is zero at a point");
                values[k] = fields_[k].inverse(values[k]);
            }
            const auto index = static_cast<std::uint32_t>(divisors_.size());
            divisors_.push_back({primitive, value, append(Kind::inverse, index, values)});
        }
        result = product(result, power({RationalTable::one, divisors_[known->second].inverse}, times));
    };
    for (const auto& [id, exponent] : parts.monomial) divide(LeafPolynomial::leaf(id), exponent);
    if (parts.primitive.degree() > 0) divide(parts.primitive, 1);
    return result;
}

Coefficient CoefficientGraph::dot(std::span<GraphTerm> terms) {
    std::span<GraphTerm> form = collected(terms);
    if (form.empty()) return {};
    if (form.size() == 1) {
        const RationalId factor = std::exchange(form[0].factor, RationalTable::one);
        if (form[0].right == one_node) return {factor, form[0].left};
        return scaled(factor, lookup(form));
    }
    const bool minus = RationalTable::is_minus(form[0].factor);
    if (minus) negate(form);
    const Coefficient result = lookup(form);
    return minus ? result.negative() : result;
}

std::span<const GraphTerm> CoefficientGraph::terms_of(NodeId node) const {
    const Form& form = forms_[nodes_[node].index];
    return {terms_.data() + form.begin, form.count};
}

// Sorted by their nodes (the larger first), equal pairs added, zeros dropped.
std::span<GraphTerm> CoefficientGraph::collected(std::span<GraphTerm> terms) {
    for (GraphTerm& t : terms)
        if (t.left < t.right) std::swap(t.left, t.right);
    if (terms.size() < 2) return terms;
    std::sort(terms.begin(), terms.end(),
              [](const GraphTerm& a, const GraphTerm& b) { return pair_of(a) < pair_of(b); });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < terms.size(); ++k) {
        if (kept > 0 && pair_of(terms[kept - 1]) == pair_of(terms[k])) {
            GraphTerm& last = terms[kept - 1];
            last.factor = rationals_.add(last.factor, terms[k].factor);
            if (last.factor == RationalTable::zero) --kept;
        } else {
            terms[kept++] = terms[k];
        }
    }
    return terms.first(kept);
}

} // namespace resonform
