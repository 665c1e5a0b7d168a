// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of products of parts with coefficients in numbers.
#include "algebra/graph/keyed_part.hpp"
#include "algebra/series/number_domain.hpp"

#include <algorithm>
#include <numeric>

namespace resonform {

namespace {

std::uint64_t hash_of(WideKey key) {
    constexpr std::uint64_t odd = 0x9E3779B97F4A7C15ULL, other = 0xBF58476D1CE4E5B9ULL;
    return static_cast<std::uint64_t>(key) * odd + static_cast<std::uint64_t>(key >> 64U) * other;
}

// One sum for each key, in the order of their first arrival.
class Sums {
public:
    arb_ptr of(WideKey key) {
        if (2 * keys_.size() >= slots_.size()) grow();
        std::size_t slot = hash_of(key) >> shift_;
        while (slots_[slot] != 0 && keys_[slots_[slot] - 1] != key) slot = (slot + 1) & (slots_.size() - 1);
        if (slots_[slot] == 0) {
            keys_.push_back(key);
            sums_.emplace_back();
            slots_[slot] = static_cast<std::uint32_t>(keys_.size());
        }
        return sums_[slots_[slot] - 1].get();
    }

    // Whether it is real is left open.
    [[nodiscard]] NumberPart collected(const OuterKeysOf<WideKey>& keys) {
        std::vector<std::pair<WideKey, RealBall>> terms;
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            keys.require_safe(keys_[k]);
            if (!sums_[k].is_zero()) terms.emplace_back(keys_[k], std::move(sums_[k]));
        }
        return part_of(std::move(terms));
    }

private:
    void grow() {
        shift_ = slots_.empty() ? 58 : shift_ - 1;
        slots_.assign(std::size_t{1} << (64 - shift_), 0);
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            std::size_t slot = hash_of(keys_[k]) >> shift_;
            while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = static_cast<std::uint32_t>(k + 1);
        }
    }

    std::vector<WideKey> keys_;
    std::vector<RealBall> sums_;
    std::vector<std::uint32_t> slots_; // number plus one; 0: free
    int shift_ = 64;
};

std::vector<RealBall> scaled(const std::vector<RealBall>& values, const Rational& factor, std::int64_t bits) {
    std::vector<RealBall> result(values.size());
    const RealBall number(factor, bits);
    for (std::size_t k = 0; k < values.size(); ++k)
        arb_mul(result[k].get(), values[k].get(), number.get(), bits);
    return result;
}

// sums += factor left right, without keys that `half` leaves to their mirrors
void multiply_out(const ProductOf<NumberPart>& product, const OuterKeysOf<WideKey>& keys, bool half,
                  std::int64_t bits, Sums& sums) {
    const NumberPart &left = *product.left, &right = *product.right;
    const std::vector<RealBall> factors = scaled(left.coefficients, product.factor, bits);
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t j = 0; j < right.size(); ++j) {
            WideKey key = left.keys[i] + right.keys[j];
            const bool minus = OuterKeysOf<WideKey>::take_square_of_i(key);
            if (half && keys.mirror(key) < key) continue;
            arb_ptr sum = sums.of(key);
            (minus ? arb_submul : arb_addmul)(sum, factors[i].get(), right.coefficients[j].get(), bits);
        }
}

NumberPart finished(const OuterKeysOf<WideKey>& keys, bool half, Sums& sums) {
    NumberPart result = sums.collected(keys);
    if (half) return with_mirrored(keys, result);
    result.real = equals_its_conjugate(keys, result);
    return result;
}

} // namespace

NumberPart NumberDomain::dot(const std::vector<ProductOf<Part>>& products) const {
    const bool half = std::all_of(products.begin(), products.end(),
                                  [](const auto& p) { return p.left->real && p.right->real; });
    Sums sums;
    for (const auto& product : products)
        if (!cln::zerop(product.factor)) multiply_out(product, keys(), half, bits(), sums);
    return finished(keys(), half, sums);
}

NumberPart NumberDomain::combination(const std::vector<std::pair<Rational, const Part*>>& addends) const {
    const bool half =
        std::all_of(addends.begin(), addends.end(), [](const auto& addend) { return addend.second->real; });
    Sums sums;
    for (const auto& [factor, part] : addends) {
        if (cln::zerop(factor)) continue;
        const std::vector<RealBall> values = scaled(part->coefficients, factor, bits());
        for (std::size_t k = 0; k < part->size(); ++k) {
            if (half && keys().mirror(part->keys[k]) < part->keys[k]) continue;
            arb_ptr sum = sums.of(part->keys[k]);
            arb_add(sum, sum, values[k].get(), bits());
        }
    }
    return finished(keys(), half, sums);
}

} // namespace resonform
