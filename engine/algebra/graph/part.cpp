// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/part.hpp"

#include <algorithm>
#include <numeric>

namespace resonform {

// Monomials numbered in the order of their first arrival, and a list of terms with their numbers.
class GraphArithmetic::Gathering {
public:
    void add(OuterKey key, const GraphTerm& term) {
        owners_.push_back(index(key));
        terms_.push_back(term);
    }
    [[nodiscard]] const std::vector<OuterKey>& keys() const { return keys_; }

    // The terms of each monomial side by side: those of number k from begin[k] to begin[k + 1].
    void arrange(std::vector<GraphTerm>& arranged, std::vector<std::size_t>& begin) const {
        begin.assign(keys_.size() + 1, 0);
        for (const std::uint32_t owner : owners_) ++begin[owner + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
        arranged.resize(terms_.size());
        for (std::size_t k = 0; k < terms_.size(); ++k) arranged[next[owners_[k]]++] = terms_[k];
    }

private:
    std::uint32_t index(OuterKey key) {
        if (2 * keys_.size() >= slots_.size()) grow();
        std::size_t slot = slot_of(key);
        while (slots_[slot] != 0 && keys_[slots_[slot] - 1] != key) slot = (slot + 1) & (slots_.size() - 1);
        if (slots_[slot] == 0) {
            keys_.push_back(key);
            slots_[slot] = static_cast<std::uint32_t>(keys_.size());
        }
        return slots_[slot] - 1;
    }
    [[nodiscard]] std::size_t slot_of(OuterKey key) const { return key * 0x9E3779B97F4A7C15ULL >> shift_; }
    void grow() {
        slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), 0);
        shift_ = slots_.size() == 64 ? 58 : shift_ - 1;
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            std::size_t slot = slot_of(keys_[k]);
            while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = static_cast<std::uint32_t>(k + 1);
        }
    }

    std::vector<OuterKey> keys_;
    std::vector<std::uint32_t> slots_; // number plus one; 0: free
    int shift_ = 64;
    std::vector<std::uint32_t> owners_;
    std::vector<GraphTerm> terms_;
};

GraphPart GraphArithmetic::constant(Coefficient c, OuterKey key) const {
    if (c.is_zero()) return {};
    GraphPart result{{key}, {c}, false};
    result.real = equals_its_conjugate(keys_, result);
    return result;
}

GraphPart GraphArithmetic::dot(const std::vector<GraphProduct>& products) const {
    Gathering gathering;
    const bool half = std::all_of(products.begin(), products.end(),
                                  [](const GraphProduct& p) { return p.left->real && p.right->real; });
    for (const GraphProduct& p : products) multiply_out(p, half, gathering);
    return collected(gathering, half);
}

void GraphArithmetic::multiply_out(const GraphProduct& product, bool half, Gathering& gathering) const {
    RationalTable& rationals = graph_->rationals();
    const RationalId factor = rationals.intern(product.factor);
    if (factor == RationalTable::zero) return;
    const GraphPart &left = *product.left, &right = *product.right;
    const bool square = &left == &right; // each product of two different terms once, doubled
    const RationalId twice = square ? rationals.multiply(rationals.intern(2), factor) : factor;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const Coefficient a = left.coefficients[i];
        const RationalId once = rationals.multiply(factor, a.factor);
        const RationalId other = square ? rationals.multiply(twice, a.factor) : once;
        for (std::size_t j = square ? i : 0; j < right.size(); ++j) {
            OuterKey key = left.keys[i] + right.keys[j];
            const bool minus = OuterKeys::take_square_of_i(key);
            if (half && keys_.mirror(key) < key) continue;
            const Coefficient b = right.coefficients[j];
            const RationalId f = rationals.multiply(square && i == j ? once : other, b.factor);
            gathering.add(key, {minus ? RationalTable::negate(f) : f, a.node, b.node});
        }
    }
}

GraphPart
GraphArithmetic::combination(const std::vector<std::pair<Rational, const GraphPart*>>& addends) const {
    Gathering gathering;
    RationalTable& rationals = graph_->rationals();
    const bool half =
        std::all_of(addends.begin(), addends.end(), [](const auto& addend) { return addend.second->real; });
    for (const auto& [number, part] : addends) {
        const RationalId factor = rationals.intern(number);
        if (factor == RationalTable::zero) continue;
        for (std::size_t k = 0; k < part->size(); ++k) {
            if (half && keys_.mirror(part->keys[k]) < part->keys[k]) continue;
            const Coefficient c = part->coefficients[k];
            gathering.add(part->keys[k],
                          {rationals.multiply(factor, c.factor), c.node, CoefficientGraph::one_node});
        }
    }
    return collected(gathering, half);
}

GraphPart GraphArithmetic::collected(Gathering& gathering, bool half) const {
    const std::vector<OuterKey>& keys = gathering.keys();
    std::vector<GraphTerm> terms;
    std::vector<std::size_t> begin, order(keys.size());
    gathering.arrange(terms, begin);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    GraphPart result;
    for (const std::size_t k : order) {
        keys_.require_safe(keys[k]);
        const Coefficient c = graph_->dot(std::span(terms).subspan(begin[k], begin[k + 1] - begin[k]));
        if (c.is_zero()) continue;
        result.append(keys[k], c);
    }
    if (half) return with_mirrored(keys_, result);
    result.real = equals_its_conjugate(keys_, result);
    return result;
}

Coefficient GraphArithmetic::times(int number, Coefficient c) const {
    return graph_->scaled(graph_->rationals().intern(number), c);
}

GraphPart GraphArithmetic::derivative(const GraphPart& p, int field) const {
    return derivative_of(keys_, p, field, [&](int k, Coefficient c) { return times(k, c); });
}

GraphPart GraphArithmetic::angle_derivative(const GraphPart& p, int field) const {
    return angle_derivative_of(keys_, p, field, [&](int k, Coefficient c) { return times(k, c); });
}

} // namespace resonform
