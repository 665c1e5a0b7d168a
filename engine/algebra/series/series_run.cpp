// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of a SeriesProgram, one weight at a time. With the Euler derivation D = sum over weights
// n (part n), each function obeys a linear equation: D s = c Du, D e = e Du, u Dl = Du, u Dp = a p Du.
#include "algebra/graph/domain.hpp"
#include "algebra/number/error.hpp"
#include "algebra/series/number_domain.hpp"
#include "algebra/series/series_history.hpp"
#include "algebra/series/series_program.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace resonform {
namespace {

using Node = SeriesProgram::Node;
using Op = SeriesProgram::Op;

std::size_t at(Node node) { return static_cast<std::size_t>(node); }

template <class Domain, class Part> Part scaled(const Domain& domain, const Rational& factor, const Part& p) {
    return domain.combination({{factor, &p}});
}

template <class Domain, class Part> Part difference(const Domain& domain, const Part& a, const Part& b) {
    return domain.combination({{1, &a}, {-1, &b}});
}

template <class Domain, class Part> Part sum(const Domain& domain, const Part& a, const Part& b) {
    return domain.combination({{1, &a}, {1, &b}});
}

template <class Domain, class Part> Part product(const Domain& domain, const Part& a, const Part& b) {
    return domain.dot({{1, &a, &b}});
}

template <class Domain> typename Domain::Part number(const Domain&, std::size_t) {
    throw std::logic_error("SeriesRun: numbers that no ring holds want the domain of numbers");
}

NumberPart number(const NumberDomain& domain, std::size_t index) { return domain.number(index); }

template <class Domain> bool is_one(const Domain& domain, const typename Domain::Part& p) {
    return p == domain.one();
}

bool is_one(const NumberDomain& domain, const NumberPart& p) { return domain.is_one(p); }

void require_start(bool holds, const std::string& rule) {
    if (holds) return;
    refuse(Reason::singular, {.rule = rule,
                              .value = "another finite value",
                              .hint = "expand about the equilibrium, or declare the argument small",
                              .place = {}});
}

[[noreturn]] void refuse_start(const SeriesProgram::Instruction& power) {
    refuse({.rule = "the ring of coefficients holds the leading part of a root or a denominator as a product "
                    "of parameters, roots and numbers",
            .value = "a power " + to_string(power.exponent) + " of another sum",
            .hint = "write a parameter for the sum, or take numbers: --digits 30",
            .place = power.place});
}

// By node: its operands that no later node uses.
std::vector<std::vector<Node>> last_operands(const std::vector<SeriesProgram::Instruction>& all) {
    std::vector<std::size_t> last(all.size(), 0);
    for (std::size_t k = 0; k < all.size(); ++k) {
        for (const Node operand : {all[k].left, all[k].right})
            if (operand >= 0) last[at(operand)] = std::max(last[at(operand)], k);
        for (const auto& addend : all[k].addends)
            last[at(addend.second)] = std::max(last[at(addend.second)], k);
    }
    std::vector<std::vector<Node>> operands(all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
        if (last[k] > k) operands[last[k]].push_back(static_cast<Node>(k));
    return operands;
}

} // namespace

template <class Domain>
BasicSeriesRun<Domain>::BasicSeriesRun(const SeriesProgram& program, Domain domain)
    : program_(&program), domain_(std::move(domain)), constants_(program.instructions().size()),
      values_(program.instructions().size()), fused_(program.instructions().size()), one_(domain_.one()),
      reciprocals_(program.instructions().size()) {
    find_fused();
    for (std::size_t k = 0; k < constants_.size(); ++k) {
        const std::vector<Polynomial>& parts = program.instructions()[k].parts;
        for (std::size_t n = 0; n < parts.size(); ++n)
            constants_[k].set(static_cast<int>(n), domain_.constant(parts[n]));
        if (program.instructions()[k].op == Op::number)
            constants_[k].set(0, number(domain_, program.instructions()[k].index));
    }
}

template <class Domain> void BasicSeriesRun<Domain>::set_input(Node input, int weight, Part part) {
    if (program_->instructions()[at(input)].op != Op::input || weight < weight_) {
        throw std::logic_error("SeriesRun::set_input: not an input, or a weight that is already settled");
    }
    part = domain_.reduce(std::move(part));
    if (weight == weight_) // before correct(), parts that are computed must not see it yet
        changed_.emplace_back(input, std::move(part));
    else
        values_[at(input)].series.set(weight, std::move(part));
}

template <class Domain> void BasicSeriesRun<Domain>::advance(int weight) {
    if (weight != weight_ + 1 || !changed_.empty()) {
        throw std::logic_error("SeriesRun::advance: weights come in order 0, 1, 2, ...; correct() first");
    }
    weight_ = weight;
    if (weight == 0) start();
}

template <class Domain> void BasicSeriesRun<Domain>::start() {
    for (std::size_t k = 0; k < values_.size(); ++k) {
        if (program_->instructions()[k].op != Op::input)
            values_[k].series.set(0, first_part(static_cast<Node>(k)));
        values_[k].next = 1;
    }
}

template <class Domain> void BasicSeriesRun<Domain>::forget() {
    const std::vector<int> history = histories(*program_);
    for (std::size_t k = 0; k < values_.size(); ++k) {
        Value& value = values_[k];
        if (history[k] == whole_history) continue;
        for (int n = value.forgotten + 1; n <= std::min(weight_ - history[k], value.next - 1); ++n) {
            value.series.set(n, {});
            value.forgotten = n;
        }
    }
}

template <class Domain> auto BasicSeriesRun<Domain>::part(Node node, int weight) const -> const Part& {
    Value& value = values_[at(node)];
    if (0 < weight && weight <= value.forgotten) throw std::logic_error("SeriesRun::part: it was given back");
    for (; value.next <= std::min(weight, weight_); ++value.next)
        if (program_->instructions()[at(node)].op != Op::input)
            value.series.set(value.next, next_part(node, value.next));
    return value.series.part(weight);
}

template <class Domain> auto BasicSeriesRun<Domain>::series(Node node) const -> const BasicSeries<Part>& {
    static_cast<void>(part(node, weight_));
    return values_[at(node)].series;
}

// Whether a constant has no part of this weight. The other factor, perhaps freed, is not read then.
template <class Domain> bool BasicSeriesRun<Domain>::is_beyond(Node node, int weight) const {
    const Op op = program_->instructions()[at(node)].op;
    return (op == Op::constant || op == Op::number) && weight > constants_[at(node)].through();
}

// The lighter part is asked for first: if it is zero, the heavier may never be needed.
template <class Domain> bool BasicSeriesRun<Domain>::vanishes(const Wanted& w) const {
    if (is_beyond(w.left, w.i) || is_beyond(w.right, w.j)) return true;
    if (w.i <= w.j) return part(w.left, w.i).empty() || part(w.right, w.j).empty();
    return part(w.right, w.j).empty() || part(w.left, w.i).empty();
}

// The products that do not vanish; their parts stay in place until another part is computed.
template <class Domain>
auto BasicSeriesRun<Domain>::present(std::vector<Wanted> wanted) const -> std::vector<ProductOf<Part>> {
    std::erase_if(wanted, [&](const Wanted& w) { return vanishes(w); });
    std::vector<ProductOf<Part>> products;
    for (const Wanted& w : wanted) products.push_back({w.factor, &part(w.left, w.i), &part(w.right, w.j)});
    return products;
}

template <class Domain> auto BasicSeriesRun<Domain>::dot(std::vector<Wanted> wanted) const -> Part {
    return domain_.dot(present(std::move(wanted)));
}

// [u v]_n = sum_j u_j v_{n-j}; of a square each product of two different parts once, doubled.
template <class Domain>
auto BasicSeriesRun<Domain>::factors(const Rational& factor, Node u, Node v, int n) -> std::vector<Wanted> {
    std::vector<Wanted> wanted;
    for (int j = 0; j <= (u == v ? n / 2 : n); ++j)
        wanted.push_back({u == v && 2 * j != n ? 2 * factor : factor, u, j, v, n - j});
    return wanted;
}

// (sign/n) sum_{j=1}^n j u_j v_{n-j}: part n of f with Df = sign v Du.
template <class Domain>
auto BasicSeriesRun<Domain>::integrated(Node u, Node v, int n, int sign) const -> Part {
    std::vector<Wanted> wanted;
    for (int j = 1; j <= n; ++j) wanted.push_back({Rational(sign * j) / Rational(n), u, j, v, n - j});
    return dot(std::move(wanted));
}

template <class Domain> auto BasicSeriesRun<Domain>::first_part(Node node) -> Part {
    const SeriesProgram::Instruction& in = program_->instructions()[at(node)];
    const auto u = [&]() -> const Part& { return part(in.left, 0); };
    switch (in.op) {
    case Op::sine:
    case Op::antiderivative:
        require_start(in.op != Op::sine || domain_.is_zero(u()), "a sine is expanded about zero");
        return {};
    case Op::cosine:
        require_start(domain_.is_zero(u()), "a cosine is expanded about zero");
        return domain_.one();
    case Op::exponential:
        require_start(domain_.is_zero(u()), "an exponential is expanded about exp(0)");
        return domain_.one();
    case Op::logarithm:
        require_start(is_one(domain_, u()), "a logarithm is expanded about log(1)");
        return {};
    case Op::power: {
        const std::optional<Part> reciprocal = domain_.inverse(u());
        const std::optional<Part> power = domain_.rational_power(u(), in.exponent);
        if (!reciprocal || !power) refuse_start(in);
        reciprocals_[at(node)] = *reciprocal;
        return *power;
    }
    default: return next_part(node, 0);
    }
}

template <class Domain> auto BasicSeriesRun<Domain>::next_part(Node node, int weight) const -> Part {
    const SeriesProgram::Instruction& in = program_->instructions()[at(node)];
    const int n = weight;
    switch (in.op) {
    case Op::input: return values_[at(node)].series.part(n);
    case Op::constant:
    case Op::number: return constants_[at(node)].part(n);
    case Op::sum: return combined(in, n);
    case Op::product: return dot(factors(1, in.left, in.right, n));
    case Op::sine:
    case Op::antiderivative: return integrated(in.left, in.right, n);
    case Op::cosine: return integrated(in.left, in.right, n, -1);
    case Op::exponential: return integrated(in.left, node, n);
    case Op::logarithm: { // n u_n = n l_n + sum_{j=1}^{n-1} j l_j u_{n-j}, as u_0 = 1
        std::vector<Wanted> wanted;
        for (int j = 1; j < n; ++j) wanted.push_back({Rational(j) / Rational(n), node, j, in.left, n - j});
        return difference(domain_, part(in.left, n), dot(std::move(wanted)));
    }
    case Op::power: { // u_0 n p_n = sum_{j=1}^n (a j - (n - j)) u_j p_{n-j}
        std::vector<Wanted> wanted;
        for (int j = 1; j <= n; ++j)
            wanted.push_back(
                {(in.exponent * Rational(j) - Rational(n - j)) / Rational(n), in.left, j, node, n - j});
        return resonform::product(domain_, dot(std::move(wanted)), reciprocals_[at(node)]);
    }
    }
    throw std::logic_error("SeriesRun: unknown operation");
}

template <class Domain>
auto BasicSeriesRun<Domain>::combined(const SeriesProgram::Instruction& sum, int n) const -> Part {
    std::vector<Wanted> wanted;
    for (const auto& [factor, addend] : sum.addends) {
        if (fused_[at(addend)]) {
            const SeriesProgram::Instruction& product = program_->instructions()[at(addend)];
            const std::vector<Wanted> more = factors(factor, product.left, product.right, n);
            wanted.insert(wanted.end(), more.begin(), more.end());
        } else {
            static_cast<void>(part(addend, n)); // computed first: later it might move other parts
        }
    }
    std::vector<ProductOf<Part>> products = present(std::move(wanted));
    std::vector<std::pair<Rational, const Part*>> addends;
    for (const auto& [factor, addend] : sum.addends)
        if (!fused_[at(addend)] && !part(addend, n).empty()) addends.emplace_back(factor, &part(addend, n));
    if (products.empty()) return domain_.combination(addends);
    for (const auto& [factor, addend] : addends) products.push_back({factor, addend, &one_});
    return domain_.dot(products);
}

template <class Domain> void BasicSeriesRun<Domain>::find_fused() {
    const auto& instructions = program_->instructions();
    std::vector<int> uses(instructions.size(), 0);
    for (const SeriesProgram::Instruction& in : instructions) {
        for (const Node operand : {in.left, in.right})
            if (operand >= 0) uses[at(operand)] += 2; // not by a sum
        for (const auto& addend : in.addends) ++uses[at(addend.second)];
    }
    for (std::size_t k = 0; k < instructions.size(); ++k)
        fused_[k] = instructions[k].op == Op::product && uses[k] == 1;
}

template <class Domain> void BasicSeriesRun<Domain>::correct(int weight) {
    if (weight != weight_)
        throw std::logic_error("SeriesRun::correct: only the last weight can be corrected");
    std::vector<Part> deltas(values_.size());
    for (auto& [input, part] : std::exchange(changed_, {})) {
        BasicSeries<Part>& series = values_[at(input)].series;
        deltas[at(input)] = sum(domain_, deltas[at(input)], difference(domain_, part, series.part(weight)));
        series.set(weight, std::move(part));
    }
    if (weight == 0) return start();
    const std::vector<std::vector<Node>> last_used_by = last_operands(program_->instructions());
    for (std::size_t k = 0; k < values_.size(); ++k) {
        Value& value = values_[k];
        const bool known = value.next > weight;
        if (program_->instructions()[k].op == Op::input || (!known && !fused_[k])) continue;
        deltas[k] = change(static_cast<Node>(k), deltas);
        if (known && !deltas[k].empty())
            value.series.set(weight, sum(domain_, value.series.part(weight), deltas[k]));
        for (const Node node : last_used_by[k]) deltas[at(node)] = {};
    }
}

// The change of part n >= 1 of a node, given those of its operands; parts below n are settled.
template <class Domain>
auto BasicSeriesRun<Domain>::change(Node node, const std::vector<Part>& deltas) const -> Part {
    const SeriesProgram::Instruction& in = program_->instructions()[at(node)];
    switch (in.op) {
    case Op::input:
    case Op::constant:
    case Op::number:
    case Op::cosine: return {}; // d(cos u)_n = -s_0 du_n, s_0 = 0
    case Op::sum: {
        std::vector<std::pair<Rational, const Part*>> addends;
        for (const auto& [factor, addend] : in.addends) addends.emplace_back(factor, &deltas[at(addend)]);
        return domain_.combination(addends);
    }
    case Op::product:
        return domain_.dot(
            {{1, &part(in.left, 0), &deltas[at(in.right)]}, {1, &part(in.right, 0), &deltas[at(in.left)]}});
    case Op::sine:
    case Op::exponential:
    case Op::logarithm: return deltas[at(in.left)]; // c_0 = e_0 = u_0 = 1
    case Op::antiderivative: return resonform::product(domain_, part(in.right, 0), deltas[at(in.left)]);
    case Op::power:
        return scaled(domain_, in.exponent,
                      resonform::product(domain_,
                                         resonform::product(domain_, part(node, 0), reciprocals_[at(node)]),
                                         deltas[at(in.left)]));
    }
    throw std::logic_error("SeriesRun: unknown operation");
}

template class BasicSeriesRun<RingDomain>;
template class BasicSeriesRun<GraphDomain>;
template class BasicSeriesRun<NumberDomain>;

} // namespace resonform
