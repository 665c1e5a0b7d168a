// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/products.hpp"

#include "algebra/ring/common_denominator.hpp"
#include "algebra/ring/monomial_table.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <future>
#include <limits>
#include <thread>
#include <utility>

namespace resonform {
namespace {

__extension__ using Wide = __int128;
__extension__ using UnsignedWide = unsigned __int128;

// Bits that hold every sum, with its sign.
std::size_t bits_of_sums(const std::vector<WholeProduct>& products) {
    std::size_t bits = 0, summands = 0;
    for (const WholeProduct& p : products) {
        bits = std::max(bits, p.bits);
        summands += std::min(p.left->size(), p.right->size());
    }
    return bits + static_cast<std::size_t>(std::bit_width(summands)) + 1;
}

// Whether all numerators have one limb, and all sums fit into a word or two.
bool fits_words(const std::vector<WholeProduct>& products, std::size_t bits) {
    return bits <= 128 && std::all_of(products.begin(), products.end(), [](const WholeProduct& p) {
               return p.left->limbs == 1 && p.right->limbs == 1 && p.left->bits() < 64 &&
                      p.right->bits() < 64;
           });
}

template <class Sum> Sum signed_numerator(const Fractions& f, std::size_t k) {
    const Sum magnitude = static_cast<Sum>(f.magnitudes[k]);
    return f.negative[k] != 0 ? -magnitude : magnitude;
}

template <class Sum> void store(Fractions& f, Sum value) {
    const bool minus = value < 0;
    const UnsignedWide magnitude =
        minus ? -static_cast<UnsignedWide>(value) : static_cast<UnsignedWide>(value);
    f.negative.push_back(minus ? 1 : 0);
    f.magnitudes.push_back(static_cast<mp_limb_t>(magnitude));
    if constexpr (sizeof(Sum) == sizeof(Wide))
        f.magnitudes.push_back(static_cast<mp_limb_t>(magnitude >> 64));
}

template <class Sum> Fractions room_for(std::size_t terms) {
    Fractions f;
    f.limbs = sizeof(Sum) / sizeof(mp_limb_t);
    f.monomials.reserve(terms);
    f.negative.reserve(terms);
    f.magnitudes.reserve(terms * f.limbs);
    return f;
}

// The monomials of a sum that are collected together: all, or those in which one exponent is odd (even).
// Parities add in a product, so that the pairs of a share are known beforehand.
class Share {
public:
    Share() = default;
    Share(const Packing& packing, int field, unsigned parity)
        : packing_(&packing), field_(field), wanted_(parity) {}

    [[nodiscard]] bool is_all() const { return packing_ == nullptr; }
    [[nodiscard]] unsigned parity(const Monomial& m) const {
        return packing_ == nullptr ? 0 : static_cast<unsigned>(packing_->exponent(m, field_)) & 1U;
    }
    // By parity of a left factor: the right factors that it meets.
    [[nodiscard]] std::array<std::vector<std::uint32_t>, 2> partners(const Fractions& right) const {
        std::array<std::vector<std::uint32_t>, 2> of;
        for (std::size_t j = 0; j < right.size(); ++j)
            of[parity(right.monomials[j]) ^ wanted_].push_back(static_cast<std::uint32_t>(j));
        return of;
    }

private:
    const Packing* packing_ = nullptr;
    int field_ = 0;
    unsigned wanted_ = 0;
};

// All numerators of the operands have one limb, all sums fit into Sum.
template <class Sum> class WordSums {
public:
    void add(const WholeProduct& p, const Share& share) {
        const Fractions &left = *p.left, &right = *p.right;
        right_.resize(right.size());
        for (std::size_t j = 0; j < right.size(); ++j) right_[j] = signed_numerator<Sum>(right, j);
        MonomialTable::hash_all(right.monomials, hashes_);
        if (share.is_all())
            return add_pairs(p, [&](std::size_t, auto pair) {
                for (std::size_t j = 0; j < right.size(); ++j) pair(j);
            });
        const auto partners = share.partners(right);
        add_pairs(p, [&](std::size_t i, auto pair) {
            for (const std::uint32_t j : partners[share.parity(left.monomials[i])]) pair(j);
        });
    }

    [[nodiscard]] Fractions numerators() const {
        const auto zeros = std::count(sums_.begin(), sums_.end(), Sum{0});
        Fractions result = room_for<Sum>(sums_.size() - static_cast<std::size_t>(zeros));
        for (std::size_t k = 0; k < sums_.size(); ++k) {
            if (sums_[k] == 0) continue;
            result.monomials.push_back(table_.monomials()[k]);
            store(result, sums_[k]);
        }
        return result;
    }

private:
    // partners(i, pair) calls pair(j) for the right factors j that the left factor i meets.
    template <class Partners> void add_pairs(const WholeProduct& p, Partners partners) {
        for (std::size_t i = 0; i < p.left->size(); ++i) {
            const Monomial& m = p.left->monomials[i];
            const std::uint64_t hash = MonomialTable::hash(m);
            const Sum left = signed_numerator<Sum>(*p.left, i) * p.factor;
            partners(i, [&](std::size_t j) {
                const std::size_t k = table_.index(m + p.right->monomials[j], hash + hashes_[j]);
                if (k == sums_.size()) sums_.push_back(0);
                sums_[k] += left * right_[j];
            });
        }
    }

    MonomialTable table_;
    std::vector<Sum> sums_;
    std::vector<Sum> right_;            // of the product that is added
    std::vector<std::uint64_t> hashes_; // of its right monomials
};

bool is_multiple_of_term(const std::vector<WholeProduct>& products) {
    return products.size() == 1 && products.front().left->size() == 1;
}

// A multiple of one term: nothing has to be collected.
template <class Sum> Fractions shifted(const WholeProduct& p) {
    Fractions result = room_for<Sum>(p.right->size());
    const Sum left = signed_numerator<Sum>(*p.left, 0) * p.factor;
    for (std::size_t j = 0; j < p.right->size(); ++j) {
        result.monomials.push_back(p.left->monomials[0] + p.right->monomials[j]);
        store(result, left * signed_numerator<Sum>(*p.right, j));
    }
    return result;
}
Fractions shifted(const WholeProduct& p, std::size_t bits) {
    return bits <= 64 ? shifted<std::int64_t>(p) : shifted<Wide>(p);
}

template <class Sum> Fractions sum_in_words(const std::vector<WholeProduct>& products, const Share& share) {
    WordSums<Sum> sums;
    for (const WholeProduct& p : products) sums.add(p, share);
    return sums.numerators();
}

// Sums of `width` limbs in two's complement.
class LimbSums {
public:
    explicit LimbSums(std::size_t width) : width_(width) {}

    void grow() { limbs_.resize(limbs_.size() + width_, 0); }
    [[nodiscard]] std::size_t size() const { return limbs_.size() / width_; }

    // sums[k] += or -= the product of limbs a and b.
    void add(std::size_t k, const mp_limb_t* a, std::size_t a_limbs, const mp_limb_t* b, std::size_t b_limbs,
             bool subtract) {
        product_.resize(a_limbs + b_limbs);
        multiply_limbs(product_.data(), a, a_limbs, b, b_limbs);
        const std::size_t low = std::min(product_.size(), width_);
        mp_limb_t* sum = limbs_.data() + k * width_;
        const auto size = static_cast<mp_size_t>(low), rest = static_cast<mp_size_t>(width_ - low);
        if (subtract) {
            const mp_limb_t borrow = mpn_sub_n(sum, sum, product_.data(), size);
            if (borrow != 0 && rest > 0) mpn_sub_1(sum + low, sum + low, rest, 1);
        } else {
            const mp_limb_t carry = mpn_add_n(sum, sum, product_.data(), size);
            if (carry != 0 && rest > 0) mpn_add_1(sum + low, sum + low, rest, 1);
        }
    }

    // The sums that are not zero, of these monomials; in place, as both may be long.
    [[nodiscard]] Fractions numerators(std::vector<Monomial> monomials) && {
        Fractions f;
        f.limbs = width_;
        std::size_t kept = 0;
        for (std::size_t k = 0; k < monomials.size(); ++k) {
            mp_limb_t* sum = limbs_.data() + k * width_;
            if (std::all_of(sum, sum + width_, [](mp_limb_t l) { return l == 0; })) continue;
            const bool minus = sum[width_ - 1] >> 63 != 0;
            if (minus) mpn_neg(sum, sum, static_cast<mp_size_t>(width_));
            f.negative.push_back(minus ? 1 : 0);
            std::copy_n(sum, width_, limbs_.data() + kept * width_);
            monomials[kept++] = monomials[k];
        }
        monomials.resize(kept);
        limbs_.resize(kept * width_);
        f.monomials = std::move(monomials);
        f.magnitudes = std::move(limbs_);
        return f;
    }

private:
    std::size_t width_;
    std::vector<mp_limb_t> limbs_, product_;
};

Fractions sum_in_limbs(const std::vector<WholeProduct>& products, std::size_t width, const Share& share) {
    MonomialTable table;
    LimbSums sums(width);
    std::vector<std::uint64_t> hashes;
    for (const WholeProduct& p : products) {
        const Fractions &left = *p.left, &right = *p.right;
        MonomialTable::hash_all(right.monomials, hashes);
        const auto partners = share.partners(right);
        for (std::size_t i = 0; i < left.size(); ++i) {
            const Monomial& m = left.monomials[i];
            const std::uint64_t hash = MonomialTable::hash(m);
            for (const std::uint32_t j : partners[share.parity(m)]) {
                const std::size_t k = table.index(m + right.monomials[j], hash + hashes[j]);
                if (k == sums.size()) sums.grow();
                sums.add(k, left.magnitude(i), left.limbs, right.magnitude(j), right.limbs,
                         left.negative[i] != right.negative[j]);
            }
        }
    }
    return std::move(sums).numerators(std::move(table).monomials());
}

// `bits` of the sums; `in_words` by fits_words(). All factors must be 1 if it is false.
Fractions sum_over(const std::vector<WholeProduct>& products, std::size_t bits, bool in_words,
                   const Share& share) {
    if (!in_words) return sum_in_limbs(products, (bits + 63) / 64, share);
    return bits <= 64 ? sum_in_words<std::int64_t>(products, share) : sum_in_words<Wide>(products, share);
}

std::size_t work(const WholeProduct& p) { return p.left->size() * p.right->size(); }

bool is_worth_two_threads(const std::vector<WholeProduct>& products) {
    constexpr std::size_t enough = std::size_t{1} << 16; // a millisecond: a thread starts in a tenth of that
    std::size_t all = 0;
    for (const WholeProduct& p : products) all += work(p);
    return all >= enough && std::thread::hardware_concurrency() > 1;
}

// The field whose exponent is odd in about half of the right factors of the largest product.
int dividing_field(const Packing& packing, const std::vector<WholeProduct>& products) {
    const auto largest =
        std::max_element(products.begin(), products.end(),
                         [](const WholeProduct& a, const WholeProduct& b) { return work(a) < work(b); });
    const std::vector<Monomial>& monomials = largest->right->monomials;
    constexpr std::size_t sample = 128;
    const std::size_t step = monomials.size() / sample + 1;
    int best = 0;
    long least = std::numeric_limits<long>::max();
    for (int field = 0; field < packing.fields(); ++field) {
        long excess = 0;
        for (std::size_t k = 0; k < monomials.size(); k += step)
            excess += packing.exponent(monomials[k], field) % 2 == 0 ? 1 : -1;
        if (std::abs(excess) >= least) continue;
        least = std::abs(excess);
        best = field;
    }
    return best;
}

// Two threads collect disjoint shares of the monomials, so that nothing has to be merged. They meet the
// numbers of GMP only: those of CLN count their references without locks.
Fractions sum_in_two_threads(const Packing& packing, const std::vector<WholeProduct>& products,
                             std::size_t bits, bool in_words) {
    const int field = dividing_field(packing, products);
    const auto collect = [&](unsigned parity) {
        return sum_over(products, bits, in_words, Share(packing, field, parity));
    };
    std::future<Fractions> other = std::async(std::launch::async, collect, 1U);
    Fractions result = collect(0);
    const Fractions odd = other.get(); // with as many limbs, as that follows from the products
    result.monomials.insert(result.monomials.end(), odd.monomials.begin(), odd.monomials.end());
    result.magnitudes.insert(result.magnitudes.end(), odd.magnitudes.begin(), odd.magnitudes.end());
    result.negative.insert(result.negative.end(), odd.negative.begin(), odd.negative.end());
    return result;
}

} // namespace

Fractions sum_of_products(const std::vector<FractionProduct>& products, const Packing* packing) {
    CommonDenominator common(products);
    const std::vector<WholeProduct>& whole = common.products();
    const std::size_t bits = bits_of_sums(whole);
    const bool in_words = fits_words(whole, bits);
    if (!in_words) common.multiply_factors();
    Fractions result = in_words && is_multiple_of_term(whole) ? shifted(whole.front(), bits)
                       : packing != nullptr && is_worth_two_threads(whole)
                           ? sum_in_two_threads(*packing, whole, bits, in_words)
                           : sum_over(whole, bits, in_words, Share());
    result.denominator = common.denominator();
    return result;
}

Fractions collected(const Fractions& f) {
    const Fractions one = constant_fraction(1);
    const std::size_t bits = f.bits() + static_cast<std::size_t>(std::bit_width(f.size())) + 1;
    const std::vector<WholeProduct> whole{whole_product(one, f, 1)};
    Fractions result = sum_over(whole, bits, fits_words(whole, bits), Share());
    result.denominator = f.denominator;
    return result;
}

void require_safe(const Packing& packing, const std::vector<FractionProduct>& products) {
    for (const FractionProduct& p : products)
        for (const Fractions* f : {p.left, p.right})
            for (const Monomial& m : f->monomials) packing.require_safe(m);
}

} // namespace resonform
