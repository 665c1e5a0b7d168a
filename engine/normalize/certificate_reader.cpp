// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_reader.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace resonform {

ExponentReader::ExponentReader(const Ring& ring)
    : ring_(ring), per_word_(ring.packing().fields_per_word()),
      words_((ring.size() + per_word_ - 1) / per_word_),
      exponents_(static_cast<std::size_t>(ring.size()), 0) {}

int ExponentReader::read(const Monomial& m) {
    int from = started_ ? words_ : 0; // all words count as new the first time
    started_ = true;
    for (int word = words_; word-- > 0;) {
        const auto w = static_cast<std::size_t>(word);
        if (m.word[w] == last_.word[w]) continue;
        from = word;
        decode(m, word);
    }
    last_ = m;
    return from;
}

void ExponentReader::decode(const Monomial& m, int word) {
    const auto w = static_cast<std::size_t>(word);
    counts_[w] = 0;
    const int end = std::min((word + 1) * per_word_, ring_.size());
    for (GeneratorId id = word * per_word_; id < end; ++id) {
        const int e = ring_.exponent(m, id);
        exponents_[static_cast<std::size_t>(id)] = e;
        powers_[w][counts_[w]] = {id, e};
        if (e != 0) ++counts_[w];
    }
}

void PointReader::Wanted::add_slope(GeneratorId by) {
    place_[static_cast<std::size_t>(by)] = static_cast<int>(slopes_.size());
    slopes_.push_back(by);
    slope_sums_.push_back(0);
    slope_values_.push_back(0);
}

PointReader::PointReader(const Ring& ring, const Montgomery& montgomery,
                         const std::vector<Residue>& generators)
    : montgomery_(montgomery), exponents_(ring) {
    // All inverses by one: 1/a_k = (a_0 ... a_{k-1}) / (a_0 ... a_k).
    Half& here = halves_[0];
    std::vector<Residue> products{montgomery.enter(1)};
    for (const Residue g : generators) {
        here.values.push_back(montgomery.enter(g));
        products.push_back(montgomery.multiply(products.back(), here.values.back()));
    }
    Residue inverse = montgomery.inverse(products.back());
    here.inverses.resize(generators.size());
    for (std::size_t k = generators.size(); k-- > 0;) {
        here.inverses[k] = montgomery.multiply(inverse, products[k]);
        inverse = montgomery.multiply(inverse, here.values[k]);
    }
    Half& there = halves_[1];
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        const auto k = static_cast<std::size_t>(g.conjugate >= 0 ? g.conjugate : id);
        const bool turned = g.kind == GeneratorKind::phase, negated = id == Ring::imaginary_unit;
        const Residue value = turned ? here.inverses[k] : here.values[k];
        const Residue below = turned ? here.values[k] : here.inverses[k];
        there.values.push_back(negated ? montgomery.negate(value) : value);
        there.inverses.push_back(negated ? montgomery.negate(below) : below);
    }
    for (Half& half : halves_) {
        for (const Residue value : half.values) half.powers.push_back({value});
        for (const Residue value : half.inverses) half.negative_powers.push_back({value});
        half.products[0] = montgomery.enter(1);
    }
    const Residue base = montgomery.enter(montgomery.enter(1)); // 2^128
    limb_factors_.push_back(base);
}

inline Residue PointReader::power(Half& half, const ExponentReader::Power& p) const {
    const auto id = static_cast<std::size_t>(p.id), n = static_cast<std::size_t>(std::abs(p.exponent));
    std::vector<Residue>& known = p.exponent < 0 ? half.negative_powers[id] : half.powers[id];
    while (known.size() < n) known.push_back(montgomery_.multiply(known.back(), known.front()));
    return known[n - 1];
}

void PointReader::multiply_words(Half& half, int from) const {
    for (int word = from; word < exponents_.words(); ++word) {
        Residue product = half.products[static_cast<std::size_t>(word)];
        for (const ExponentReader::Power& p : exponents_.powers(word))
            product = montgomery_.multiply(product, power(half, p));
        half.products[static_cast<std::size_t>(word) + 1] = product;
    }
}

// The limbs of its numerators can be read after that.
Residue PointReader::inverse_of_denominator(const Fractions& part) {
    while (limb_factors_.size() < part.limbs) // times 2^64
        limb_factors_.push_back(montgomery_.enter(limb_factors_.back()));
    const mpz_srcptr denominator = part.denominator.get_mpz_t();
    if (mpz_cmp_ui(denominator, 1) == 0) return montgomery_.enter(1);
    const Residue below = montgomery_.field().from_limbs(mpz_limbs_read(denominator), mpz_size(denominator));
    if (below == 0) throw UnluckyPoint();
    return montgomery_.enter(montgomery_.field().inverse(below));
}

Residue PointReader::numerator(const Fractions& part, std::size_t k) const {
    const mp_limb_t* limbs = part.magnitude(k);
    Montgomery::Wide sum = 0;
    for (std::size_t limb = 0; limb < part.limbs; ++limb)
        montgomery_.accumulate(sum, limb_factors_[limb], limbs[limb]);
    const Residue value = montgomery_.reduce(sum);
    return part.negative[k] != 0 ? montgomery_.negate(value) : value;
}

Residue PointReader::reduced(Signed sum) const {
    if (sum == 0) return 0;
    const auto size = static_cast<Montgomery::Wide>(sum < 0 ? -sum : sum);
    const std::uint64_t limbs[] = {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)};
    const Residue value = montgomery_.field().from_limbs(limbs, 2);
    return sum < 0 ? montgomery_.negate(value) : value;
}

void PointReader::read(const Fractions& part, std::vector<Wanted>& wanted) {
    const Residue cofactor = inverse_of_denominator(part);
    // Residues have 61 bits, exponents at most 16: 2^50 terms would fit.
    for (Wanted& w : wanted) {
        w.sum_ = 0;
        std::fill(w.slope_sums_.begin(), w.slope_sums_.end(), 0);
    }
    const int words = exponents_.words();
    for (std::size_t k = 0; k < part.size(); ++k) {
        const Residue number = numerator(part, k);
        const int from = exponents_.read(part.monomials[k]);
        for (Half& half : halves_) half.fresh = std::min(half.fresh, from);
        for (Wanted& w : wanted) {
            Half& half = halves_[static_cast<std::size_t>(w.side_)];
            multiply_words(half, half.fresh);
            half.fresh = words;
            const auto value = static_cast<Signed>(
                montgomery_.multiply(number, half.products[static_cast<std::size_t>(words)]));
            w.sum_ += value;
            if (w.slopes_.empty()) continue;
            for (int word = 0; word < words; ++word)
                for (const ExponentReader::Power& p : exponents_.powers(word))
                    if (const int place = w.place_[static_cast<std::size_t>(p.id)]; place >= 0)
                        w.slope_sums_[static_cast<std::size_t>(place)] += value * p.exponent;
        }
    }
    for (Wanted& w : wanted) {
        const Half& half = halves_[static_cast<std::size_t>(w.side_)];
        w.value_ = montgomery_.multiply(cofactor, reduced(w.sum_));
        for (std::size_t k = 0; k < w.slopes_.size(); ++k)
            w.slope_values_[k] = montgomery_.multiply(
                montgomery_.multiply(cofactor, half.inverses[static_cast<std::size_t>(w.slopes_[k])]),
                reduced(w.slope_sums_[k]));
    }
}

std::vector<Residue> PointReader::terms(const Fractions& part) {
    std::vector<Residue> values;
    const Residue cofactor = inverse_of_denominator(part);
    Half& half = halves_[0];
    for (std::size_t k = 0; k < part.size(); ++k) {
        const int from = exponents_.read(part.monomials[k]);
        for (Half& one : halves_) one.fresh = std::min(one.fresh, from);
        multiply_words(half, half.fresh);
        half.fresh = exponents_.words();
        const Residue number = montgomery_.multiply(cofactor, numerator(part, k));
        values.push_back(
            montgomery_.multiply(number, half.products[static_cast<std::size_t>(exponents_.words())]));
    }
    return values;
}

} // namespace resonform
