// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of a SeriesProgram, one weight at a time. With the Euler derivation D = sum over weights
// n (part n), each function obeys a linear equation: D s = c Du, D e = e Du, u Dl = Du, u Dp = a p Du.
#include "algebra/error.hpp"
#include "algebra/series_program.hpp"

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace resonform {
namespace {

using Node = SeriesProgram::Node;
using Op = SeriesProgram::Op;

std::size_t at(Node node) { return static_cast<std::size_t>(node); }

// sum_{j=1}^{last} factor(j) u_j v_{n-j}
template <class Factor>
Polynomial weighted_product(const Ring& ring, const Series& u, const Series& v, int n, int last,
                            Factor factor) {
    std::vector<Product> products;
    for (int j = 1; j <= last; ++j) products.push_back({factor(j), &u.part(j), &v.part(n - j)});
    return ring.dot(products);
}

// (1/n) sum_{j=1}^n j u_j v_{n-j}: part n of f with Df = v Du.
Polynomial integrated(const Ring& ring, const Series& u, const Series& v, int n) {
    return weighted_product(ring, u, v, n, n, [n](int j) { return Rational(j) / Rational(n); });
}

void require_start(bool holds, const std::string& rule) {
    if (holds) return;
    refuse({.rule = rule,
            .value = "another finite value",
            .mend = "expand about the equilibrium, or declare the argument small",
            .place = {}});
}

} // namespace

SeriesRun::SeriesRun(const SeriesProgram& program)
    : program_(&program), values_(program.instructions().size()),
      reciprocals_(program.instructions().size()) {}

void SeriesRun::set_input(Node input, int weight, Polynomial part) {
    if (program_->instructions()[at(input)].op != Op::input || weight < weight_) {
        throw std::logic_error("SeriesRun::set_input: not an input, or a weight that is already settled");
    }
    part = program_->ring()->reduce(std::move(part));
    if (weight == weight_) changed_.emplace_back(input, part - values_[at(input)].part(weight));
    values_[at(input)].set(weight, std::move(part));
}

void SeriesRun::advance(int weight) {
    if (weight != weight_ + 1 || !changed_.empty()) {
        throw std::logic_error("SeriesRun::advance: weights come in order 0, 1, 2, ...; correct() first");
    }
    weight_ = weight;
    if (weight == 0) return start();
    for (std::size_t k = 0; k < values_.size(); ++k) {
        if (program_->instructions()[k].op == Op::input) continue;
        values_[k].set(weight, next_part(static_cast<Node>(k), weight));
    }
}

void SeriesRun::start() {
    for (std::size_t k = 0; k < values_.size(); ++k) {
        if (program_->instructions()[k].op == Op::input) continue;
        values_[k].set(0, first_part(static_cast<Node>(k)));
    }
}

Polynomial SeriesRun::first_part(Node node) {
    const SeriesProgram::Instruction& in = program_->instructions()[at(node)];
    const Ring& ring = *program_->ring();
    const auto u = [&]() -> const Polynomial& { return part(in.left, 0); };
    switch (in.op) {
    case Op::sine:
    case Op::antiderivative:
        require_start(in.op != Op::sine || u().empty(), "a sine is expanded about zero");
        return {};
    case Op::cosine: require_start(u().empty(), "a cosine is expanded about zero"); return ring.one();
    case Op::exponential:
        require_start(u().empty(), "an exponential is expanded about exp(0)");
        return ring.one();
    case Op::logarithm: require_start(u() == ring.one(), "a logarithm is expanded about log(1)"); return {};
    case Op::power: {
        const std::optional<Polynomial> reciprocal = ring.inverse(u());
        const std::optional<Polynomial> power = ring.rational_power(u(), in.exponent);
        require_start(
            reciprocal && power,
            "a negative or broken power is expanded about a unit whose power the coefficients hold");
        reciprocals_[at(node)] = *reciprocal;
        return *power;
    }
    default: return next_part(node, 0);
    }
}

Polynomial SeriesRun::next_part(Node node, int weight) const {
    const SeriesProgram::Instruction& in = program_->instructions()[at(node)];
    const Ring& ring = *program_->ring();
    const int n = weight;
    const auto value = [&](Node operand) -> const Series& { return values_[at(operand)]; };
    switch (in.op) {
    case Op::input: return value(node).part(n);
    case Op::constant: return at(n) < in.parts.size() ? in.parts[at(n)] : Polynomial();
    case Op::sum: {
        std::vector<std::pair<Rational, const Polynomial*>> addends;
        for (const auto& [factor, addend] : in.addends) addends.emplace_back(factor, &part(addend, n));
        return combination(addends);
    }
    case Op::product: return product_part(ring, value(in.left), value(in.right), n);
    case Op::sine:
    case Op::antiderivative: return integrated(ring, value(in.left), value(in.right), n);
    case Op::cosine: return -integrated(ring, value(in.left), value(in.right), n);
    case Op::exponential: return integrated(ring, value(in.left), value(node), n);
    case Op::logarithm: // n u_n = n l_n + sum_{j=1}^{n-1} j l_j u_{n-j}, as u_0 = 1
        return part(in.left, n) - weighted_product(ring, value(node), value(in.left), n, n - 1,
                                                   [n](int j) { return Rational(j) / Rational(n); });
    case Op::power: { // u_0 n p_n = sum_{j=1}^n (a j - (n - j)) u_j p_{n-j}
        const Polynomial sum = weighted_product(ring, value(in.left), value(node), n, n, [&](int j) {
            return (in.exponent * Rational(j) - Rational(n - j)) / Rational(n);
        });
        return ring.multiply(sum, reciprocals_[at(node)]);
    }
    }
    throw std::logic_error("SeriesRun: unknown operation");
}

void SeriesRun::correct(int weight) {
    if (weight != weight_)
        throw std::logic_error("SeriesRun::correct: only the last weight can be corrected");
    std::vector<Polynomial> deltas(values_.size());
    for (auto& entry : std::exchange(changed_, {})) {
        deltas[at(entry.first)] = deltas[at(entry.first)] + entry.second;
    }
    if (weight == 0) return start();
    for (std::size_t k = 0; k < values_.size(); ++k) {
        if (program_->instructions()[k].op == Op::input) continue;
        deltas[k] = change(static_cast<Node>(k), deltas);
        if (!deltas[k].empty()) values_[k].set(weight, values_[k].part(weight) + deltas[k]);
    }
}

// The change of part n >= 1 of a node, given those of its operands; parts below n are settled.
Polynomial SeriesRun::change(Node node, const std::vector<Polynomial>& deltas) const {
    const SeriesProgram::Instruction& in = program_->instructions()[at(node)];
    const Ring& ring = *program_->ring();
    switch (in.op) {
    case Op::input:
    case Op::constant:
    case Op::cosine: return {}; // d(cos u)_n = -s_0 du_n, s_0 = 0
    case Op::sum: {
        std::vector<std::pair<Rational, const Polynomial*>> addends;
        for (const auto& [factor, addend] : in.addends) addends.emplace_back(factor, &deltas[at(addend)]);
        return combination(addends);
    }
    case Op::product:
        return ring.dot(
            {{&part(in.left, 0), &deltas[at(in.right)]}, {&part(in.right, 0), &deltas[at(in.left)]}});
    case Op::sine:
    case Op::exponential:
    case Op::logarithm: return deltas[at(in.left)]; // c_0 = e_0 = u_0 = 1
    case Op::antiderivative: return ring.multiply(part(in.right, 0), deltas[at(in.left)]);
    case Op::power:
        return in.exponent *
               ring.multiply(ring.multiply(part(node, 0), reciprocals_[at(node)]), deltas[at(in.left)]);
    }
    throw std::logic_error("SeriesRun: unknown operation");
}

const Polynomial& SeriesRun::part(Node node, int weight) const { return values_[at(node)].part(weight); }

const Series& SeriesRun::series(Node node) const { return values_[at(node)]; }

} // namespace resonform
