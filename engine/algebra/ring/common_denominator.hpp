// SPDX-License-Identifier: GPL-3.0-or-later
// Products of fractions over one common denominator, so that their sum is one of whole numbers.
#pragma once

#include "algebra/ring/fractions.hpp"

#include <cstdint>
#include <deque>
#include <vector>

namespace resonform {

// factor * left * right is numerator over the common denominator.
struct WholeProduct {
    const Fractions* left; // the shorter one
    const Fractions* right;
    std::int64_t factor;
    std::size_t bits; // of the largest numerator, with the factor
};

class CommonDenominator {
public:
    explicit CommonDenominator(const std::vector<FractionProduct>& products);

    // Those that are not zero.
    [[nodiscard]] const std::vector<WholeProduct>& products() const { return whole_; }
    [[nodiscard]] const mpz_class& denominator() const { return denominator_; }
    // Makes all factors 1.
    void multiply_factors();

private:
    bool fill_in_words(const std::vector<FractionProduct>& products);
    void fill(const std::vector<FractionProduct>& products);

    std::vector<WholeProduct> whole_;
    std::deque<Fractions> scaled_; // left operands with their factors; a deque leaves them in their places
    mpz_class denominator_ = 1;
};

WholeProduct whole_product(const Fractions& a, const Fractions& b, std::int64_t factor);

// product = a b; it has as many limbs as both together.
void multiply_limbs(mp_limb_t* product, const mp_limb_t* a, std::size_t a_limbs, const mp_limb_t* b,
                    std::size_t b_limbs);

} // namespace resonform
