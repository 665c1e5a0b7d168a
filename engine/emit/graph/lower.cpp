// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/graph/lower.hpp"

#include "emit/display/display.hpp"
#include "emit/display/divisor_fractions.hpp"
#include "emit/display/spelling.hpp"
#include "emit/graph/differences.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace resonform {

namespace {

[[noreturn]] void divides_by_zero(const Ring& ring, const Generator& g) {
    const std::string name =
        g.kind == GeneratorKind::root ? spell(display(ring, g.radicand), text_spelling()) : g.name;
    throw DivisionByZero(ErrorKind::refused, {"a value that is divided by must not be zero",
                                              name + " = 0",
                                              "change it under [fix]",
                                              {},
                                              Reason::singular});
}

} // namespace

void Lowering::define(GeneratorId id, Graph::Node node, bool varying) {
    nodes_[static_cast<std::size_t>(id)] = node;
    change_[static_cast<std::size_t>(id)] = varying                         ? Change::calls
                                            : std::isnan(rough_value(node)) ? Change::starts
                                                                            : Change::never;
}

// Adds a term with the generators that are numbers put in.
void Lowering::fold(const Monomial& m, Rational coefficient, Terms& terms) const {
    terms.width = nodes_.size();
    terms.exponents.resize(terms.exponents.size() + terms.width, 0);
    int* row = terms.row(terms.coefficients.size());
    for (std::size_t id = 0; id < nodes_.size(); ++id) {
        const int exponent = ring_->exponent(m, static_cast<GeneratorId>(id));
        if (exponent == 0) continue;
        if (nodes_[id] < 0)
            throw std::logic_error("lowering: no node for " + ring_->generator(static_cast<int>(id)).name);
        const Graph::Entry& entry = graph_->at(nodes_[id]);
        if (entry.op != Graph::Op::rational) {
            row[id] = exponent;
            continue;
        }
        if (entry.value == 0 && exponent < 0)
            divides_by_zero(*ring_, ring_->generator(static_cast<GeneratorId>(id)));
        coefficient = coefficient * cln::expt(entry.value, exponent);
    }
    terms.coefficients.push_back(std::move(coefficient));
}

std::vector<std::size_t> Lowering::varying_roots() const {
    std::vector<std::size_t> roots;
    for (std::size_t id = 0; id < nodes_.size(); ++id)
        if (change_[id] == Change::calls &&
            ring_->generator(static_cast<GeneratorId>(id)).kind == GeneratorKind::root)
            roots.push_back(id);
    return roots;
}

std::vector<std::size_t> Lowering::collected(Terms& terms, const std::vector<std::size_t>& roots) const {
    std::vector<std::size_t> rows(terms.coefficients.size()), different;
    std::iota(rows.begin(), rows.end(), 0);
    const auto order = [&](std::size_t a, std::size_t b) {
        const int *left = terms.row(a), *right = terms.row(b);
        for (const std::size_t root : roots)
            if (left[root] != right[root]) return left[root] < right[root];
        return std::lexicographical_compare(left, left + terms.width, right, right + terms.width);
    };
    std::sort(rows.begin(), rows.end(), order);
    for (const std::size_t k : rows) {
        if (different.empty() || order(different.back(), k)) {
            different.push_back(k);
            continue;
        }
        Rational& sum = terms.coefficients[different.back()];
        sum = sum + terms.coefficients[k];
    }
    return different;
}

Graph::Node Lowering::fractions(const std::vector<Fraction>& list) {
    Terms terms;
    std::vector<Graph::Node> sum;
    for (const Fraction& f : list) {
        Terms own;
        Terms& target = f.divisors.empty() ? terms : own;
        for (const Term& t : f.numerator.terms()) fold(f.factor + t.monomial, t.coefficient, target);
        if (f.divisors.empty()) continue;
        std::vector<Graph::Node> factors{lowered(own)};
        for (const Polynomial& divisor : f.divisors) factors.push_back(power(conditioned(divisor), -1));
        sum.push_back(graph_->multiply(factors));
    }
    const Graph::Node rest = lowered(terms);
    if (sum.empty()) return rest;
    sum.push_back(rest);
    return graph_->add(std::move(sum));
}

Graph::Node Lowering::power(Graph::Node x, int exponent) const {
    if (exponent < 0 && graph_->at(x).op == Graph::Op::exp) { // 0 where 1/e^u would divide by infinity
        const Graph::Node u = graph_->at(x).operands.front();
        const Graph::Node minus = graph_->multiply({graph_->rational(-1), u});
        return graph_->power(graph_->function(Graph::Op::exp, {minus}), -exponent);
    }
    const auto known = inverses_.find(x);
    return exponent < 0 && known != inverses_.end() ? graph_->power(known->second, -exponent)
                                                    : graph_->power(x, exponent);
}

// What is left of a sum when its multiples of e^u - 1 are taken out, and these:
//
//   y + e^u/2 - 1 + e^-u/2   ->   y + expm1(u)^2 e^-u/2
template <class Sum> Graph::Node Lowering::by_exponentials(Terms& terms, const Sum& sum) {
    std::optional<Divided> divided = without_exponential(terms);
    if (!divided) return sum(terms);
    const Graph::Node less_one = graph_->function(Graph::Op::expm1, {divided->argument});
    const Graph::Node rest = by_exponentials(terms, sum);
    return graph_->add({rest, graph_->multiply({less_one, by_exponentials(divided->terms, sum)})});
}

Graph::Node Lowering::lowered(Terms& terms) {
    return by_exponentials(terms, [this](Terms& sum) { return by_roots(sum); });
}

Graph::Node Lowering::by_roots(Terms& terms) {
    const std::vector<std::size_t> roots = varying_roots();
    std::vector<std::size_t> rows = collected(terms, roots);
    std::vector<Graph::Node> sum;
    for (auto group = rows.begin(); group != rows.end();) {
        const auto end = std::find_if(group, rows.end(), [&](std::size_t k) {
            return std::any_of(roots.begin(), roots.end(), [&](std::size_t root) {
                return terms.row(k)[root] != terms.row(*group)[root];
            });
        });
        sum.push_back(sum_of(terms, {group, end}));
        group = end;
    }
    return graph_->add(std::move(sum));
}

Graph::Node Lowering::radicand(const Polynomial& p) {
    Terms terms;
    for (const Term& t : p.terms()) fold(t.monomial, t.coefficient, terms);
    return by_exponentials(terms, [this](Terms& sum) {
        std::vector<std::size_t> rows = collected(sum, {});
        return sum_of(sum, rows, true);
    });
}

Graph::Node Lowering::sum_of(Terms& terms, Rows rows, bool is_radicand) {
    const auto zeros =
        std::remove_if(rows.begin(), rows.end(), [&](std::size_t k) { return terms.coefficients[k] == 0; });
    if (zeros == rows.begin()) return graph_->rational(0);
    return horner(terms, {rows.begin(), zeros}, Change::calls, is_radicand);
}

bool Lowering::is_exponential(std::size_t id) const {
    return nodes_[id] >= 0 && graph_->at(nodes_[id]).op == Graph::Op::exp;
}

// Takes the greatest common monomial out of the terms; only in generators that change alike. No
// power of an exponential changes its sign by that: e^-2u + 1 as e^-2u (1 + e^2u) would be 0 times infinity
// early.
Graph::Node Lowering::common_factor(Terms& terms, Rows rows, Change change) {
    const int* const first = terms.row(rows.front());
    std::vector<int> common(first, first + terms.width);
    for (const std::size_t k : rows)
        for (std::size_t id = 0; id < common.size(); ++id) {
            const int own = terms.row(k)[id];
            if (!is_exponential(id))
                common[id] = std::min(common[id], own);
            else if (own == 0 || (own > 0) != (common[id] > 0))
                common[id] = 0;
            else if (std::abs(own) < std::abs(common[id]))
                common[id] = own;
        }
    std::vector<Graph::Node> factors;
    for (std::size_t id = 0; id < common.size(); ++id) {
        if (change_[id] != change) common[id] = 0;
        if (common[id] == 0) continue;
        factors.push_back(power(nodes_[id], common[id]));
        for (const std::size_t k : rows) terms.row(k)[id] -= common[id];
    }
    return graph_->multiply(factors);
}

// The generator of the kind asked for that most terms have in common, the first of equals; -1: none.
int Lowering::most_frequent(const Terms& terms, Rows rows, Change change) const {
    std::vector<std::ptrdiff_t> counts(terms.width, 0);
    for (const std::size_t k : rows)
        for (std::size_t id = 0; id < counts.size(); ++id)
            if (terms.row(k)[id] != 0) ++counts[id];
    for (std::size_t id = 0; id < counts.size(); ++id)
        if (change_[id] != change) counts[id] = 0;
    const auto most = std::max_element(counts.begin(), counts.end());
    return most == counts.end() || *most == 0 ? -1 : static_cast<int>(most - counts.begin());
}

// After the common factor all exponents are >= 0, but those of exponentials. A sum without generators of
// one change goes on with those of the next; without any it is a number. The rows are divided in place, each
// term belongs to one sum.
Graph::Node Lowering::horner(Terms& terms, Rows rows, Change change, bool is_radicand) {
    const Graph::Node factor = common_factor(terms, rows, change);
    const int id = most_frequent(terms, rows, change);
    if (id < 0) {
        const Graph::Node rest =
            change == Change::never
                ? graph_->rational(terms.coefficients[rows.front()])
                : horner(terms, rows, change == Change::calls ? Change::starts : Change::never, is_radicand);
        return graph_->multiply({factor, rest});
    }
    const int sign =
        std::any_of(rows.begin(), rows.end(), [&](std::size_t k) { return terms.row(k)[id] > 0; }) ? 1 : -1;
    const auto without =
        std::partition(rows.begin(), rows.end(), [&](std::size_t k) { return sign * terms.row(k)[id] > 0; });
    const Graph::Node with = horner(terms, {rows.begin(), without}, change, is_radicand);
    const Graph::Node sum = graph_->add({with, horner(terms, {without, rows.end()}, change, is_radicand)});
    if (!is_radicand)
        return graph_->multiply({factor, change == Change::never ? without_lost_digits(sum) : sum});
    const Graph::Node factored = factored_difference(*graph_, multiplied_out(*graph_, sum));
    if (positive_.contains(sum)) positive_.insert(factored);
    return graph_->multiply({factor, factored});
}

} // namespace resonform
