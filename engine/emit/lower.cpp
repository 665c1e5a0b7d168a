// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/lower.hpp"

#include "emit/display.hpp"
#include "emit/divisor_fractions.hpp"
#include "emit/spelling.hpp"

#include <algorithm>
#include <stdexcept>

namespace resonform {

namespace {

[[noreturn]] void divides_by_zero(const Ring& ring, const Generator& g) {
    const std::string name =
        g.kind == GeneratorKind::root ? spell(display(ring, g.radicand), text_spelling()) : g.name;
    throw DivisionByZero(
        Kind::refused,
        {"a value that is divided by must not be zero", name + " = 0", "change it under [fix]", {}});
}

} // namespace

void Lowering::define(GeneratorId id, Graph::Node node, bool varying) {
    nodes_[static_cast<std::size_t>(id)] = node;
    varying_[static_cast<std::size_t>(id)] = varying;
}

// Adds a term with the generators that are numbers put in.
void Lowering::fold(const Monomial& m, Rational coefficient, Terms& terms) const {
    Exponents exponents = ring_->exponents(m);
    for (std::size_t id = 0; id < nodes_.size(); ++id) {
        if (exponents[id] == 0) continue;
        if (nodes_[id] < 0)
            throw std::logic_error("lowering: no node for " + ring_->generator(static_cast<int>(id)).name);
        const Graph::Entry& entry = graph_->at(nodes_[id]);
        if (entry.op != Graph::Op::rational) continue;
        if (entry.value == 0 && exponents[id] < 0)
            divides_by_zero(*ring_, ring_->generator(static_cast<GeneratorId>(id)));
        coefficient = coefficient * cln::expt(entry.value, exponents[id]);
        exponents[id] = 0;
    }
    Rational& sum = terms.try_emplace(std::move(exponents), 0).first->second;
    sum = sum + coefficient;
}

Lowering::Exponents Lowering::root_powers(const Exponents& exponents) const {
    Exponents result(exponents.size(), 0);
    for (std::size_t id = 0; id < exponents.size(); ++id)
        if (varying_[id] && ring_->generator(static_cast<int>(id)).kind == GeneratorKind::root)
            result[id] = exponents[id];
    return result;
}

Graph::Node Lowering::polynomial(const Polynomial& p) {
    std::map<Exponents, Terms> groups; // by powers of roots
    for (const auto& [over, above] : divisor_fractions(*ring_, p))
        for (const auto& [outer, numerator] : ring_->expanded_form(above))
            for (const Term& t : numerator.terms()) {
                Terms term;
                fold(over + outer + t.monomial, t.coefficient, term);
                const auto& [exponents, coefficient] = *term.begin();
                Rational& sum = groups[root_powers(exponents)].try_emplace(exponents, 0).first->second;
                sum = sum + coefficient;
            }
    std::vector<Graph::Node> sum;
    sum.reserve(groups.size());
    for (auto& [powers, terms] : groups) sum.push_back(horner(std::move(terms), true));
    return graph_->add(std::move(sum));
}

Graph::Node Lowering::radicand(const Polynomial& p) {
    Terms terms;
    for (const Term& t : p.terms()) fold(t.monomial, t.coefficient, terms);
    return horner(std::move(terms), true);
}

// Takes the greatest common monomial out of the terms; only in varying or only in constant generators.
Graph::Node Lowering::common_factor(Terms& terms, bool varying) {
    Exponents least = terms.begin()->first;
    for (const auto& term : terms)
        for (std::size_t id = 0; id < least.size(); ++id) least[id] = std::min(least[id], term.first[id]);
    std::vector<Graph::Node> factors;
    for (std::size_t id = 0; id < least.size(); ++id) {
        if (varying_[id] != varying) least[id] = 0;
        if (least[id] != 0) factors.push_back(graph_->power(nodes_[id], least[id]));
    }
    Terms rest;
    for (const auto& term : terms) {
        Exponents exponents = term.first;
        for (std::size_t id = 0; id < least.size(); ++id) exponents[id] -= least[id];
        rest.emplace(std::move(exponents), term.second);
    }
    terms = std::move(rest);
    return graph_->multiply(factors);
}

// The generator of the kind asked for that most terms have in common, the first of equals; -1: none.
int Lowering::most_frequent(const Terms& terms, bool varying) const {
    int best = -1;
    std::ptrdiff_t most = 0;
    for (std::size_t id = 0; id < nodes_.size(); ++id) {
        if (varying_[id] != varying) continue;
        const auto count =
            std::count_if(terms.begin(), terms.end(), [&](const auto& term) { return term.first[id] != 0; });
        if (count > most) {
            best = static_cast<int>(id);
            most = count;
        }
    }
    return best;
}

// After the common factor all exponents are >= 0. A sum without varying generators goes on with the
// constant ones; without these it is a number.
Graph::Node Lowering::horner(Terms terms, bool varying) {
    for (auto term = terms.begin(); term != terms.end();)
        term = term->second == 0 ? terms.erase(term) : std::next(term);
    if (terms.empty()) return graph_->rational(0);
    const Graph::Node factor = common_factor(terms, varying);
    const int id = most_frequent(terms, varying);
    if (id < 0) {
        const Graph::Node rest =
            varying ? horner(std::move(terms), false) : graph_->rational(terms.begin()->second);
        return graph_->multiply({factor, rest});
    }
    Terms with, without;
    for (auto& term : terms) (term.first[static_cast<std::size_t>(id)] != 0 ? with : without).insert(term);
    const Graph::Node first = horner(std::move(with), varying);
    return graph_->multiply({factor, graph_->add({first, horner(std::move(without), varying)})});
}

} // namespace resonform
