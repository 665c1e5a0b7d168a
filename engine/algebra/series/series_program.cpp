// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/series/series_program.hpp"

#include "algebra/ring/fractions.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace resonform {

namespace {

// Equal instructions have equal ones.
std::size_t hash_of(const SeriesProgram::Instruction& instruction) {
    std::size_t hash = static_cast<std::size_t>(instruction.op);
    const auto mix = [&](std::size_t value) { hash = (hash ^ value) * 0x9e3779b97f4a7c15U + (hash >> 29); };
    const auto mix_number = [&](const Rational& value) { mix(cln::equal_hashcode(value)); };
    mix(instruction.index);
    mix(static_cast<std::size_t>(instruction.left));
    mix(static_cast<std::size_t>(instruction.right));
    mix_number(instruction.exponent);
    for (const auto& [factor, node] : instruction.addends) {
        mix_number(factor);
        mix(static_cast<std::size_t>(node));
    }
    for (const Polynomial& part : instruction.parts) {
        const Fractions& fractions = part.fractions();
        for (const Monomial& monomial : fractions.monomials)
            for (const std::uint64_t word : monomial.word) mix(word);
        for (const mp_limb_t limb : fractions.magnitudes) mix(limb);
        for (const std::uint8_t sign : fractions.negative) mix(sign);
        mix(fractions.denominator.get_ui());
    }
    return hash;
}

SeriesProgram::Instruction operation(SeriesProgram::Op op, SeriesProgram::Node left = -1,
                                     SeriesProgram::Node right = -1) {
    SeriesProgram::Instruction result;
    result.op = op;
    result.left = left;
    result.right = right;
    return result;
}

} // namespace

SeriesProgram::SeriesProgram(RingPtr ring) : ring_(std::move(ring)) {}

SeriesProgram::Node SeriesProgram::append(Instruction instruction) {
    instructions_.push_back(std::move(instruction));
    return static_cast<Node>(instructions_.size()) - 1;
}

SeriesProgram::Node SeriesProgram::intern(Instruction instruction) {
    const std::size_t hash = hash_of(instruction);
    const auto [first, last] = shared_.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (instructions_[static_cast<std::size_t>(known->second)] == instruction) return known->second;
    const Node node = append(std::move(instruction));
    shared_.emplace(hash, node);
    return node;
}

SeriesProgram::Node SeriesProgram::input(std::string name) {
    Instruction in = operation(Op::input);
    in.name = std::move(name);
    return append(std::move(in));
}

SeriesProgram::Node SeriesProgram::constant(const Polynomial& p) {
    const Polynomial reduced = ring_->reduce(p);
    int through = 0;
    for (const Term& t : reduced.terms()) through = std::max(through, ring_->weight(t.monomial));
    Instruction c = operation(Op::constant);
    c.parts = ring_->by_weight(reduced, through);
    return intern(std::move(c));
}

SeriesProgram::Node SeriesProgram::number(std::size_t index) {
    Instruction n = operation(Op::number);
    n.index = index;
    return intern(std::move(n));
}

SeriesProgram::Node SeriesProgram::sum(const std::vector<std::pair<Rational, Node>>& addends) {
    std::map<Node, Rational> collected;
    for (const auto& addend : addends) collected[addend.second] = collected[addend.second] + addend.first;
    Instruction s = operation(Op::sum);
    for (const auto& entry : collected) {
        if (!cln::zerop(entry.second)) s.addends.emplace_back(entry.second, entry.first);
    }
    if (s.addends.empty()) return constant(Polynomial());
    if (s.addends.size() == 1 && s.addends.front().first == 1) return s.addends.front().second;
    return intern(std::move(s));
}

SeriesProgram::Node SeriesProgram::product(Node a, Node b) {
    return intern(operation(Op::product, std::min(a, b), std::max(a, b)));
}

// Sine and cosine need each other's lower parts: each names the other as its right operand.
SeriesProgram::Node SeriesProgram::sine(Node u) {
    for (const auto& known : trigonometric_) {
        if (known.first == u) return known.second.first;
    }
    const Node first = static_cast<Node>(instructions_.size());
    append(operation(Op::sine, u, first + 1));
    append(operation(Op::cosine, u, first));
    trigonometric_.push_back({u, {first, first + 1}});
    return first;
}

SeriesProgram::Node SeriesProgram::cosine(Node u) { return sine(u) + 1; }

SeriesProgram::Node SeriesProgram::exponential(Node u) { return intern(operation(Op::exponential, u)); }

SeriesProgram::Node SeriesProgram::logarithm(Node u) { return intern(operation(Op::logarithm, u)); }

SeriesProgram::Node SeriesProgram::antiderivative(Node u, Node slope) {
    return intern(operation(Op::antiderivative, u, slope));
}

SeriesProgram::Node SeriesProgram::power(Node u, const Rational& exponent, const Place& place) {
    if (cln::denominator(exponent) != 1 || cln::minusp(exponent)) {
        Instruction p = operation(Op::power, u);
        p.exponent = exponent;
        p.place = place;
        return intern(std::move(p));
    }
    const Integer n = cln::numerator(exponent);
    if (n == 0) return constant(ring_->one());
    if (n == 1) return u;
    if (cln::oddp(n)) return product(power(u, n - 1), u);
    const Node half = power(u, cln::exquo(n, 2));
    return product(half, half);
}

} // namespace resonform
