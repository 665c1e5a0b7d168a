// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/replay.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace resonform {

namespace {

// The nodes that the wanted ones need, operands included.
std::vector<bool> needed_nodes(const CoefficientGraph& graph, const std::vector<Coefficient>& wanted) {
    std::vector<bool> needed(graph.size(), false);
    for (const Coefficient& c : wanted)
        if (!c.is_zero()) needed[c.node] = true;
    for (std::size_t k = graph.size(); k-- > 0;) {
        const auto node = static_cast<NodeId>(k);
        if (!needed[k]) continue;
        if (graph.kind(node) == CoefficientGraph::Kind::inverse)
            needed[graph.divisor_value(graph.index_of(node)).node] = true;
        if (graph.kind(node) != CoefficientGraph::Kind::sum) continue;
        for (const GraphTerm& t : graph.terms_of(node)) needed[t.left] = needed[t.right] = true;
    }
    return needed;
}

} // namespace

GraphReplay::GraphReplay(const CoefficientGraph& graph, const std::vector<Coefficient>& wanted)
    : factors_{1} {
    const std::vector<bool> needed = needed_nodes(graph, wanted);
    std::vector<std::uint32_t> step_of(graph.size());
    std::unordered_map<RationalId, std::uint32_t> factor_of{{RationalTable::one, 0}};
    const auto factor = [&](RationalId id) {
        const auto [known, fresh] = factor_of.emplace(id, static_cast<std::uint32_t>(factors_.size()));
        if (fresh) factors_.push_back(graph.rationals().value(id));
        return known->second;
    };
    for (std::size_t k = 0; k < graph.size(); ++k) {
        if (!needed[k]) continue;
        const auto node = static_cast<NodeId>(k);
        step_of[k] = static_cast<std::uint32_t>(steps_.size());
        Step step{graph.kind(node), 0, 0, 0, false};
        if (step.kind == CoefficientGraph::Kind::leaf) {
            step.index = graph.index_of(node);
            leaves_.push_back(step.index);
        } else if (step.kind == CoefficientGraph::Kind::inverse) {
            // A divisor is primitive and not a sum with one term: its node, or the negative of that.
            const Coefficient divisor = graph.divisor_value(graph.index_of(node));
            step.minus = divisor.factor == RationalTable::minus_one;
            step.index = step_of[divisor.node];
            inverses_.emplace_back(step_of[k], graph.index_of(node));
        } else {
            step.begin = static_cast<std::uint32_t>(terms_.size());
            for (const GraphTerm& t : graph.terms_of(node))
                terms_.push_back({factor(t.factor), step_of[t.left], step_of[t.right]});
            step.end = static_cast<std::uint32_t>(terms_.size());
        }
        steps_.push_back(step);
    }
    for (const Coefficient& c : wanted)
        targets_.push_back(c.is_zero() ? Target{0, 0, true}
                                       : Target{factor(c.factor), step_of[c.node], false});
    std::sort(leaves_.begin(), leaves_.end());
}

ModularReplay::ModularReplay(const GraphReplay& replay, const PrimeField& field)
    : replay_(&replay), field_(field), form_(field), values_(replay.steps().size()) {
    for (const Rational& factor : replay.factors()) {
        const auto residue = field_.from(factor);
        if (!residue) throw std::domain_error("ModularReplay: a prime divides a denominator");
        factors_.push_back(form_.enter(*residue));
    }
}

std::optional<std::vector<ModularReplay::Block>> ModularReplay::evaluate(const std::vector<Block>& points) {
    const std::vector<GraphReplay::Step>& steps = replay_->steps();
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (steps[k].kind == CoefficientGraph::Kind::sum) {
            sum(steps[k], values_[k]);
        } else if (steps[k].kind == CoefficientGraph::Kind::inverse) {
            if (!invert(values_[steps[k].index], values_[k])) return std::nullopt;
            for (std::size_t b = 0; b < block && steps[k].minus; ++b)
                values_[k][b] = form_.negate(values_[k][b]);
        } else {
            const auto& leaves = replay_->leaves();
            const auto place =
                std::lower_bound(leaves.begin(), leaves.end(), steps[k].index) - leaves.begin();
            for (std::size_t b = 0; b < block; ++b)
                values_[k][b] = form_.enter(points[static_cast<std::size_t>(place)][b]);
        }
    }
    std::vector<Block> results;
    for (const GraphReplay::Target& t : replay_->targets()) {
        Block result{};
        for (std::size_t b = 0; b < block && !t.zero; ++b)
            result[b] = form_.leave(form_.multiply(factors_[t.factor], values_[t.step][b]));
        results.push_back(result);
    }
    return results;
}

void ModularReplay::sum(const GraphReplay::Step& step, Block& result) const {
    if (step.begin == step.end) {
        result.fill(factors_[0]);
        return;
    }
    std::array<Montgomery::Wide, block> total{};
    for (std::uint32_t k = step.begin; k < step.end; ++k) {
        const GraphTerm& t = replay_->terms()[k];
        const Block &left = values_[t.left], &right = values_[t.right];
        if (t.factor == 0) {
            for (std::size_t b = 0; b < block; ++b) form_.accumulate(total[b], left[b], right[b]);
        } else {
            const Residue factor = factors_[t.factor];
            for (std::size_t b = 0; b < block; ++b)
                form_.accumulate(total[b], form_.multiply(factor, left[b]), right[b]);
        }
    }
    for (std::size_t b = 0; b < block; ++b) result[b] = form_.reduce(total[b]);
}

// One inversion for all: 1/(x_1 ... x_k) is taken apart from the end.
bool ModularReplay::invert(const Block& values, Block& result) const {
    Residue product = factors_[0];
    for (std::size_t b = 0; b < block; ++b) {
        if (values[b] == 0) return false;
        result[b] = product;
        product = form_.multiply(product, values[b]);
    }
    Residue inverse = form_.enter(field_.inverse(form_.leave(product)));
    for (std::size_t b = block; b-- > 0;) {
        result[b] = form_.multiply(result[b], inverse);
        inverse = form_.multiply(inverse, values[b]);
    }
    return true;
}

} // namespace resonform
