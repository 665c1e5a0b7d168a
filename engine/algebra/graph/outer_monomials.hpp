// SPDX-License-Identifier: GPL-3.0-or-later
// Which monomials of a ring the keys of a series stand for: fast variables, eps and phases are in the key,
// all else is in coefficients.
#pragma once

#include "algebra/graph/outer_keys.hpp"
#include "algebra/ring/ring.hpp"

#include <vector>

namespace resonform {

template <class Word> class OuterMonomials {
public:
    // Series have exponents up to `largest`. Errors (refused): a monomial does not fit into a word.
    OuterMonomials(RingPtr ring, int largest);

    [[nodiscard]] const RingPtr& ring() const { return ring_; }
    [[nodiscard]] const OuterKeysOf<Word>& keys() const { return keys_; }
    [[nodiscard]] int field(GeneratorId id) const {
        return fields_[static_cast<std::size_t>(id)];
    } // -1: none
    // i and all generators that have a field
    [[nodiscard]] std::vector<GeneratorId> outer() const;
    [[nodiscard]] Word key(const Monomial& m) const; // of the outer generators in m
    [[nodiscard]] Monomial monomial(Word key) const;

private:
    [[nodiscard]] static OuterKeysOf<Word> keys_of(const Ring& ring, int largest);

    RingPtr ring_;
    OuterKeysOf<Word> keys_;
    std::vector<int> fields_; // by generator
};

} // namespace resonform
