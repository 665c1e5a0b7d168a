// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/series.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace resonform {
namespace {

// [a^2]_n: each product of two different parts once, doubled.
Polynomial square_part(const Ring& ring, const Series& a, int weight) {
    std::vector<Product> products;
    for (int j = 0; 2 * j <= weight; ++j)
        products.push_back({2 * j == weight ? 1 : 2, &a.part(j), &a.part(weight - j)});
    return ring.dot(products);
}

} // namespace

Series Series::split(const Ring& ring, const Polynomial& p, int through) {
    return Series(ring.by_weight(p, through));
}

const Polynomial& Series::part(int weight) const {
    static const Polynomial zero;
    if (weight < 0 || weight > through()) return zero;
    return parts_[static_cast<std::size_t>(weight)];
}

void Series::set(int weight, Polynomial p) {
    const auto n = static_cast<std::size_t>(weight);
    if (n >= parts_.size()) parts_.resize(n + 1);
    parts_[n] = std::move(p);
}

Polynomial Series::total(int through) const {
    const int last = std::min(through, this->through());
    return sum(std::vector<Polynomial>(parts_.begin(), parts_.begin() + std::max(last + 1, 0)));
}

Polynomial product_part(const Ring& ring, const Series& a, const Series& b, int weight) {
    if (&a == &b) return square_part(ring, a, weight);
    std::vector<std::pair<const Polynomial*, const Polynomial*>> pairs;
    for (int j = std::max(0, weight - b.through()); j <= std::min(weight, a.through()); ++j) {
        if (!a.part(j).empty() && !b.part(weight - j).empty())
            pairs.emplace_back(&a.part(j), &b.part(weight - j));
    }
    return ring.dot(pairs);
}

Series multiply(const Ring& ring, const Series& a, const Series& b, int through) {
    Series result;
    for (int n = 0; n <= through; ++n) result.set(n, product_part(ring, a, b, n));
    return result;
}

} // namespace resonform
