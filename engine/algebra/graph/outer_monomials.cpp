// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/outer_monomials.hpp"

namespace resonform {

namespace {

bool is_pair(const Generator& g) { return g.kind == GeneratorKind::fast && g.conjugate >= 0; }

bool is_real_outer(const Generator& g) {
    return g.kind == GeneratorKind::small || (g.kind == GeneratorKind::fast && g.conjugate < 0);
}

} // namespace

template <class Word>
OuterMonomials<Word>::OuterMonomials(RingPtr ring, int largest)
    : ring_(std::move(ring)), keys_(keys_of(*ring_, largest)),
      fields_(static_cast<std::size_t>(ring_->size()), -1) {
    int next = 0;
    const auto give = [&](GeneratorId id) { fields_[static_cast<std::size_t>(id)] = next++; };
    for (GeneratorId id = 0; id < ring_->size(); ++id) {
        const Generator& g = ring_->generator(id);
        if (!is_pair(g) || g.conjugate < id) continue;
        give(id);
        give(g.conjugate);
    }
    for (GeneratorId id = 0; id < ring_->size(); ++id)
        if (is_real_outer(ring_->generator(id))) give(id);
    for (GeneratorId id = 0; id < ring_->size(); ++id)
        if (ring_->generator(id).kind == GeneratorKind::phase) give(id);
}

template <class Word> OuterKeysOf<Word> OuterMonomials<Word>::keys_of(const Ring& ring, int largest) {
    int pairs = 0, reals = 0, phases = 0;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (is_pair(g) && g.conjugate > id) ++pairs;
        if (is_real_outer(g)) ++reals;
        if (g.kind == GeneratorKind::phase) ++phases;
    }
    return {pairs, reals, phases, largest};
}

template <class Word> std::vector<GeneratorId> OuterMonomials<Word>::outer() const {
    std::vector<GeneratorId> ids{Ring::imaginary_unit};
    for (GeneratorId id = 1; id < ring_->size(); ++id)
        if (field(id) >= 0) ids.push_back(id);
    return ids;
}

template <class Word> Word OuterMonomials<Word>::key(const Monomial& m) const {
    Word key = ring_->exponent(m, Ring::imaginary_unit) == 1 ? OuterKeysOf<Word>::imaginary : 0;
    for (GeneratorId id = 1; id < ring_->size(); ++id)
        if (field(id) >= 0)
            if (const int exponent = ring_->exponent(m, id); exponent != 0)
                key += keys_.power(field(id), exponent);
    return key;
}

template <class Word> Monomial OuterMonomials<Word>::monomial(Word key) const {
    Monomial m;
    if (OuterKeysOf<Word>::has_i(key)) m = ring_->monomial(Ring::imaginary_unit);
    for (GeneratorId id = 1; id < ring_->size(); ++id)
        if (field(id) >= 0) m = m + ring_->monomial(id, keys_.exponent(key, field(id)));
    return m;
}

template class OuterMonomials<OuterKey>;
template class OuterMonomials<WideKey>;

} // namespace resonform
