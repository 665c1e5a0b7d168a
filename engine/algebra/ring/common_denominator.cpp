// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/common_denominator.hpp"

#include "algebra/number/flint.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <numeric>
#include <optional>

namespace resonform {
namespace {

__extension__ using Wide = __int128;

Fractions times(const Fractions& f, const mpz_class& factor) {
    Fractions result;
    result.monomials = f.monomials;
    result.negative = f.negative;
    if (sgn(factor) < 0)
        for (std::uint8_t& sign : result.negative) sign ^= 1;
    const mpz_srcptr by = factor.get_mpz_t();
    result.limbs = (f.bits() + mpz_sizeinbase(by, 2) + 63) / 64;
    result.magnitudes.assign(f.size() * result.limbs, 0);
    std::vector<mp_limb_t> product(f.limbs + mpz_size(by));
    for (std::size_t k = 0; k < f.size(); ++k) {
        multiply_limbs(product.data(), f.magnitude(k), f.limbs, mpz_limbs_read(by), mpz_size(by));
        std::copy_n(product.begin(), std::min(product.size(), result.limbs),
                    result.magnitudes.begin() + static_cast<std::ptrdiff_t>(k * result.limbs));
    }
    return result;
}

std::size_t bits_of(std::int64_t factor) {
    return factor == 1 || factor == -1
               ? 0
               : static_cast<std::size_t>(std::bit_width(static_cast<std::uint64_t>(std::abs(factor))));
}

bool is_zero(const FractionProduct& p) {
    return p.left->size() == 0 || p.right->size() == 0 || cln::zerop(p.factor);
}

// Below 2^61: products of two are formed in two words and looked at.
std::optional<std::int64_t> in_word(const Integer& n) {
    return cln::integer_length(n) < 62 ? std::optional<std::int64_t>(cln::cl_I_to_long(n)) : std::nullopt;
}
std::optional<std::int64_t> in_word(const mpz_class& n) {
    return n.fits_slong_p() && mpz_sizeinbase(n.get_mpz_t(), 2) < 62 ? std::optional<std::int64_t>(n.get_si())
                                                                     : std::nullopt;
}
std::optional<std::int64_t> product_in_word(std::optional<std::int64_t> a, std::optional<std::int64_t> b) {
    if (!a || !b) return std::nullopt;
    const Wide product = static_cast<Wide>(*a) * *b;
    constexpr Wide largest = Wide{1} << 61;
    return -largest < product && product < largest ? std::optional(static_cast<std::int64_t>(product))
                                                   : std::nullopt;
}

} // namespace

// product = a b; it has as many limbs as both together.
void multiply_limbs(mp_limb_t* product, const mp_limb_t* a, std::size_t a_limbs, const mp_limb_t* b,
                    std::size_t b_limbs) {
    if (a_limbs < b_limbs) return multiply_limbs(product, b, b_limbs, a, a_limbs);
    mpn_mul(product, a, static_cast<mp_size_t>(a_limbs), b, static_cast<mp_size_t>(b_limbs));
}

WholeProduct whole_product(const Fractions& a, const Fractions& b, std::int64_t factor) {
    const bool swap = b.size() < a.size();
    return {swap ? &b : &a, swap ? &a : &b, factor, a.bits() + b.bits() + bits_of(factor)};
}

// Whether all numbers fit into words.
bool CommonDenominator::fill_in_words(const std::vector<FractionProduct>& products) {
    std::int64_t common = 1;
    std::vector<std::int64_t> own; // denominators
    own.reserve(products.size());
    for (const FractionProduct& p : products) {
        const auto operands = product_in_word(in_word(p.left->denominator), in_word(p.right->denominator));
        const auto denominator = product_in_word(operands, in_word(cln::denominator(p.factor)));
        if (!denominator) return false;
        own.push_back(*denominator);
        if (*denominator == common) continue;
        const auto multiple = product_in_word(common / std::gcd(common, *denominator), denominator);
        if (!multiple) return false;
        common = *multiple;
    }
    whole_.reserve(products.size());
    for (std::size_t k = 0; k < products.size(); ++k) {
        const FractionProduct& p = products[k];
        if (is_zero(p)) continue;
        const auto factor = product_in_word(in_word(cln::numerator(p.factor)), common / own[k]);
        if (!factor) return false;
        whole_.push_back(whole_product(*p.left, *p.right, *factor));
    }
    denominator_ = common;
    return true;
}

void CommonDenominator::fill(const std::vector<FractionProduct>& products) {
    mpz_class& common = denominator_ = 1;
    std::vector<mpz_class> own;
    for (const FractionProduct& p : products) {
        own.push_back(p.left->denominator * p.right->denominator * to_mpz(cln::denominator(p.factor)));
        if (own.back() != common) common = lcm(common, own.back());
    }
    for (std::size_t k = 0; k < products.size(); ++k) {
        const FractionProduct& p = products[k];
        if (is_zero(p)) continue;
        const mpz_class factor = to_mpz(cln::numerator(p.factor)) * (common / own[k]);
        if (const auto word = in_word(factor)) {
            whole_.push_back(whole_product(*p.left, *p.right, *word));
            continue;
        }
        const WholeProduct plain = whole_product(*p.left, *p.right, 1);
        scaled_.push_back(times(*plain.left, factor));
        whole_.push_back(whole_product(scaled_.back(), *plain.right, 1));
    }
}

CommonDenominator::CommonDenominator(const std::vector<FractionProduct>& products) {
    if (fill_in_words(products)) return;
    whole_.clear();
    fill(products);
}

void CommonDenominator::multiply_factors() {
    for (WholeProduct& p : whole_) {
        if (p.factor == 1) continue;
        scaled_.push_back(times(*p.left, p.factor));
        p.left = &scaled_.back();
        p.factor = 1;
    }
}

} // namespace resonform
