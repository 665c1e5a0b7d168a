// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/points/reader.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace resonform {

ExponentReader::ExponentReader(const Ring& ring)
    : ring_(ring), per_word_(ring.packing().fields_per_word()),
      words_((ring.size() + per_word_ - 1) / per_word_),
      exponents_(static_cast<std::size_t>(words_ * per_word_), 0) {}

ExponentReader::ExponentReader(const Ring& ring, const std::vector<GeneratorId>& through)
    : ExponentReader(ring) {
    words_ = through.empty() ? 0 : *std::max_element(through.begin(), through.end()) / per_word_ + 1;
}

int ExponentReader::read(const Monomial& m) {
    int from = words_;
    for (int word = words_; word-- > 0;) {
        const auto w = static_cast<std::size_t>(word);
        if (m.word[w] == last_.word[w]) continue;
        from = word;
        decode(m, word);
    }
    last_ = m;
    return std::exchange(started_, true) ? from : 0; // all words count as new the first time
}

void ExponentReader::decode(const Monomial& m, int word) {
    const auto w = static_cast<std::size_t>(word);
    const int first = word * per_word_;
    int* exponents = exponents_.data() + first;
    Power* powers = powers_[w].data();
    ring_.packing().visit_word(m, word, [&](int field, int exponent) {
        exponents[field] = exponent;
        *powers = {first + field, exponent};
        powers += exponent != 0 ? 1 : 0; // or it is written over
    });
    counts_[w] = static_cast<std::size_t>(powers - powers_[w].data());
}

namespace {

int head_of(const Ring& ring, const ExponentReader& exponents) {
    int words = 0;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.conjugate >= 0 || g.kind == GeneratorKind::phase || id == Ring::imaginary_unit)
            words = std::max(words, exponents.word_of(id) + 1);
    }
    return words;
}

} // namespace

PointReader::Wanted::Wanted(Side side, const std::vector<GeneratorId>& slopes) : side_(side) {
    place_.fill(-1);
    slopes_.reserve(slopes.size());
    for (const GeneratorId by : slopes) {
        place_[static_cast<std::size_t>(by)] = static_cast<int>(slopes_.size());
        slopes_.push_back({by});
    }
}

PointReader::PointReader(const Ring& ring, std::span<const Point> points)
    : exponents_(ring), head_(head_of(ring, exponents_)) {
    points_.reserve(points.size());
    for (const Point& point : points)
        points_.push_back(prepared(ring, point, static_cast<std::size_t>(exponents_.first_of(head_))));
}

PointReader::AtPoint PointReader::prepared(const Ring& ring, const Point& point, std::size_t head) {
    AtPoint at{Montgomery(point.field), {}, 0, {}, {}};
    const Montgomery& montgomery = at.montgomery;
    // All inverses by one: 1/a_k = (a_0 ... a_{k-1}) / (a_0 ... a_k).
    Half& here = at.halves[0];
    std::vector<Residue> products{montgomery.enter(1)};
    products.reserve(point.values.size() + 1);
    for (Half& half : at.halves) {
        half.values.reserve(point.values.size());
        half.inverses.reserve(point.values.size());
    }
    for (const Residue g : point.values) {
        here.values.push_back(montgomery.enter(g));
        products.push_back(g == 0 ? products.back()
                                  : montgomery.multiply(products.back(), here.values.back()));
    }
    Residue inverse = montgomery.inverse(products.back());
    here.inverses.resize(point.values.size());
    for (std::size_t k = point.values.size(); k-- > 0;) {
        if (point.values[k] == 0) continue;
        here.inverses[k] = montgomery.multiply(inverse, products[k]);
        inverse = montgomery.multiply(inverse, here.values[k]);
    }
    Half& there = at.halves[1];
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        const auto k = static_cast<std::size_t>(g.conjugate >= 0 ? g.conjugate : id);
        const bool turned = g.kind == GeneratorKind::phase, negated = id == Ring::imaginary_unit;
        const Residue value = turned ? here.inverses[k] : here.values[k];
        const Residue below = turned ? here.values[k] : here.inverses[k];
        there.values.push_back(negated ? montgomery.negate(value) : value);
        there.inverses.push_back(negated ? montgomery.negate(below) : below);
    }
    here.powers.resize(here.values.size() * span);
    there.powers.resize(head * span);
    at.one = montgomery.enter(1);
    at.tails[0] = montgomery.enter(at.one);
    constexpr std::size_t some = 16;
    at.inverses.reserve(some);
    at.limb_factors.push_back(at.one);
    return at;
}

inline Residue PointReader::power(const AtPoint& at, Half& half, const ExponentReader::Power& p) {
    constexpr int middle = static_cast<int>(span) / 2;
    if (p.exponent < -middle || p.exponent >= middle) return far_power(at, half, p);
    const int shifted = p.exponent + middle;
    const auto place = static_cast<std::size_t>(shifted);
    Residue& known = half.powers[static_cast<std::size_t>(p.id) * span + place];
    if (known == 0) known = far_power(at, half, p); // or the generator itself is zero
    return known;
}

Residue PointReader::far_power(const AtPoint& at, const Half& half, const ExponentReader::Power& p) {
    const auto id = static_cast<std::size_t>(p.id);
    return at.montgomery.power(p.exponent < 0 ? half.inverses[id] : half.values[id],
                               static_cast<std::uint64_t>(std::abs(p.exponent)));
}

inline Residue PointReader::multiplied(const AtPoint& at, Half& half, Residue product, int word) const {
    for (const ExponentReader::Power& p : exponents_.powers(word))
        product = at.montgomery.multiply(product, power(at, half, p));
    return product;
}

inline void PointReader::read_head(Side side) {
    const auto s = static_cast<std::size_t>(side);
    if (has_head_[s]) return;
    for (AtPoint& at : points_) {
        Half& half = at.halves[s];
        half.head = at.one;
        for (int word = 0; word < head_; ++word) half.head = multiplied(at, half, half.head, word);
    }
    has_head_[s] = true;
}

inline void PointReader::read_tail(AtPoint& at, int from) const {
    for (int word = std::max(from, head_); word < exponents_.words(); ++word) {
        Residue* product = at.tails.data() + (word - head_);
        product[1] = multiplied(at, at.halves[0], product[0], word);
    }
}

// Sets the factors by which read_number() turns the limbs of a numerator into a residue.
void PointReader::read_denominator(AtPoint& at, const Fractions& part) {
    const Montgomery& montgomery = at.montgomery;
    while (at.limb_factors.size() < part.limbs) // times 2^64
        at.limb_factors.push_back(montgomery.enter(at.limb_factors.back()));
    at.cofactor = montgomery.enter(1);
    const mpz_srcptr denominator = part.denominator.get_mpz_t();
    if (mpz_cmp_ui(denominator, 1) == 0) return;
    const Residue below = mpz_fdiv_ui(denominator, montgomery.field().prime());
    if (below == 0) throw UnluckyPoint();
    auto known = std::lower_bound(at.inverses.begin(), at.inverses.end(), std::pair(below, Residue{0}));
    if (known == at.inverses.end() || known->first != below)
        known = at.inverses.emplace(known, below, montgomery.enter(montgomery.field().inverse(below)));
    at.cofactor = known->second;
}

// Sets at.number to numerator k times `tail`, the tail of its monomial.
inline void PointReader::read_number(AtPoint& at, const Fractions& part, std::size_t k, Residue tail) {
    const mp_limb_t* limbs = part.magnitude(k);
    std::uint64_t number = limbs[0]; // need not be reduced
    if (part.limbs > 1) {
        Montgomery::Wide sum = 0;
        for (std::size_t limb = 0; limb < part.limbs; ++limb)
            at.montgomery.accumulate(sum, at.limb_factors[limb], limbs[limb]);
        number = at.montgomery.reduce(sum);
    }
    const Residue value = at.montgomery.multiply(number, tail);
    at.number = part.negative[k] != 0 ? at.montgomery.negate(value) : value;
}

inline Residue PointReader::reduced(const AtPoint& at, Signed sum) {
    const auto size = static_cast<Montgomery::Wide>(sum < 0 ? -sum : sum);
    const Residue value = at.montgomery.whole(size);
    return sum < 0 ? at.montgomery.negate(value) : value;
}

inline void PointReader::read_term(const Fractions& part, std::size_t k) {
    const int from = exponents_.read(part.monomials[k]);
    if (from < head_) has_head_.fill(false);
    const auto tail = static_cast<std::size_t>(exponents_.words() - head_);
    for (AtPoint& at : points_) {
        read_tail(at, from);
        read_number(at, part, k, at.tails[tail]);
    }
}

inline void PointReader::add_term(Wanted& wanted) {
    const auto side = static_cast<std::size_t>(wanted.side_);
    read_head(wanted.side_);
    std::array<std::int64_t, most_points> values;
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const AtPoint& at = points_[j];
        values[j] = static_cast<std::int64_t>(at.montgomery.multiply(at.number, at.halves[side].head));
        wanted.sum_[j] += values[j];
    }
    if (wanted.slopes_.empty()) return;
    for (int word = 0; word < exponents_.words(); ++word)
        for (const ExponentReader::Power& p : exponents_.powers(word)) {
            const int place = wanted.place_[static_cast<std::size_t>(p.id)];
            if (place < 0) continue;
            Wanted::Sums& sum = wanted.slopes_[static_cast<std::size_t>(place)].sum;
            for (std::size_t j = 0; j < points_.size(); ++j) sum[j] += Signed{values[j]} * p.exponent;
        }
}

void PointReader::finish(Wanted& wanted) const {
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const AtPoint& at = points_[j];
        const Half& half = at.halves[static_cast<std::size_t>(wanted.side_)];
        wanted.value_[j] = at.montgomery.multiply(at.cofactor, reduced(at, wanted.sum_[j]));
        for (Wanted::Slope& slope : wanted.slopes_)
            slope.value[j] = slope.sum[j] == 0
                                 ? 0
                                 : at.montgomery.multiply(
                                       at.montgomery.multiply(
                                           at.cofactor, half.inverses[static_cast<std::size_t>(slope.by)]),
                                       reduced(at, slope.sum[j]));
    }
}

void PointReader::read(const Fractions& part, std::vector<Wanted>& wanted) {
    for (AtPoint& at : points_) read_denominator(at, part);
    // Residues have 61 bits, exponents at most 16: 2^50 terms would fit.
    for (Wanted& w : wanted) {
        w.sum_.fill(0);
        for (Wanted::Slope& slope : w.slopes_) slope.sum.fill(0);
    }
    for (std::size_t k = 0; k < part.size(); ++k) {
        read_term(part, k);
        for (Wanted& w : wanted) add_term(w);
    }
    for (Wanted& w : wanted) finish(w);
}

std::vector<Residue> PointReader::terms(const Fractions& part) {
    AtPoint& at = points_.front();
    std::vector<Residue> values;
    read_denominator(at, part);
    for (std::size_t k = 0; k < part.size(); ++k) {
        read_term(part, k);
        read_head(Side::itself);
        const Residue number = at.montgomery.multiply(at.cofactor, at.number);
        values.push_back(at.montgomery.multiply(number, at.halves[0].head));
    }
    return values;
}

} // namespace resonform
