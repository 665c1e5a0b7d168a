// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/styles/lie_series.hpp"

namespace resonform {

Polynomial LieSeries::advance(const Polynomial& f) {
    ++order_;
    set(0, f);
    if (order_ == 0) return f;
    first_ = bracketed(1);
    std::vector<Polynomial> parts{f, first_};
    for (std::size_t k = 2; k <= static_cast<std::size_t>(order_); ++k) {
        parts.push_back(bracketed(k));
        set(k, parts.back());
    }
    return sum(parts);
}

void LieSeries::complete(const Polynomial& newest) {
    if (order_ > 0) set(1, first_ + newest);
}

Polynomial LieSeries::newest() const {
    const HamiltonianVector& chi = generator_.vector(order_);
    std::vector<Product> products;
    for (const auto& [id, slope] : iterates_.front().front()) products.push_back({1, &slope, &chi.at(id)});
    return generator_.ring().dot(products);
}

void LieSeries::set(std::size_t k, const Polynomial& part) {
    if (k >= iterates_.size()) iterates_.resize(k + 1);
    const auto n = static_cast<std::size_t>(order_);
    iterates_[k].resize(n + 1);
    if (part.empty()) return;
    for (const HamiltonianForm::Bracket& b : generator_.brackets())
        for (const GeneratorId id : {b.left, b.right}) {
            Polynomial slope = generator_.ring().derivative(part, id);
            if (!slope.empty()) iterates_[k][n].emplace_back(id, std::move(slope));
        }
}

// f^(k) begins at order k.
Polynomial LieSeries::bracketed(std::size_t k) const {
    const Iterate& before = iterates_[k - 1];
    const Rational factor = Rational(1) / Rational(static_cast<int>(k));
    std::vector<Product> products;
    for (int j = 1; j < order_; ++j) {
        const auto i = static_cast<std::size_t>(order_ - j);
        if (i + 1 < k) break;
        if (i >= before.size()) continue;
        for (const auto& [id, slope] : before[i])
            products.push_back({factor, &slope, &generator_.vector(j).at(id)});
    }
    return generator_.ring().dot(products);
}

} // namespace resonform
