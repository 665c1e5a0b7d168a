// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/outer_keys.hpp"

#include "algebra/number/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

template <class Word>
OuterKeysOf<Word>::OuterKeysOf(int pairs, int reals, int phases, int largest)
    : bits_(std::min(16, (static_cast<int>(8 * sizeof(Word)) - 2) / std::max(1, 2 * pairs + reals + phases))),
      first_phase_(2 * pairs + reals), phases_(phases) {
    const int held = phases > 0 ? bits_ - 2 : bits_ - 1;
    if (held < 1 || largest >= 1 << held)
        refuse(Reason::size,
               {fmt::format("the monomials of a series fit into one word of {} bits", 8 * sizeof(Word)),
                fmt::format("{} variables with exponents up to {}", fields(), largest),
                "ask for a lower order, or give frequencies numeric values with --set NAME=VALUE",
                {}});
    Word mask = ((Word{1} << bits_) - 1) << 2;
    for (int field = 0; field < fields(); ++field, mask <<= bits_) {
        const Word top = mask & ~(mask >> 1);
        guards_ |= top;
        if (field >= first_phase_)
            quarters_ |= top >> 1;
        else if (field >= 2 * pairs)
            kept_ |= mask;
        else
            (field % 2 == 0 ? first_halves_ : second_halves_) |= mask;
    }
}

// Phases stand highest, each the signed coefficient of its power of two, as in Packing.
template <class Word> int OuterKeysOf<Word>::exponent(Word key, int field) const {
    const Word all = (Word{1} << bits_) - 1;
    if (field < first_phase_) return static_cast<int>((key >> shift(field)) & all);
    const Word biased = key + 2 * quarters_;
    return static_cast<int>((biased >> shift(field)) & all) - (1 << (bits_ - 1));
}

template <class Word> Word OuterKeysOf<Word>::require_safe(Word key, int exponent) const {
    if (exponent >= 1 << (bits_ - 1) || exponent <= -(1 << (bits_ - 1))) overflow();
    require_safe(key);
    return key;
}

template <class Word> void OuterKeysOf<Word>::overflow() const {
    refuse(Reason::size,
           {fmt::format("the monomials of a series fit into one word of {} bits", 8 * sizeof(Word)),
            fmt::format("an exponent beyond {} bits for each of {} variables", bits_, fields()),
            "ask for a lower order, or give frequencies numeric values with --set NAME=VALUE",
            {}});
}

template class OuterKeysOf<OuterKey>;
template class OuterKeysOf<WideKey>;

} // namespace resonform
