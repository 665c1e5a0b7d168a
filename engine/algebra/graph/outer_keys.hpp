// SPDX-License-Identifier: GPL-3.0-or-later
// The monomials of a series whose coefficients are elsewhere: powers of i, of conjugate pairs, of real
// variables and of phases, in one additive word.
//
//   two pairs, eps: fields  i | z1 z2 | z3 z4 | eps     key(z1^2 z4) + key(i eps) = key(i z1^2 z4 eps)
#pragma once

#include <cstdint>
#include <vector>

namespace resonform {

// Word: std::uint64_t, or one of 128 bits where there are more variables.
template <class Word> class OuterKeysOf {
public:
    // Fields are numbered: 2 k and 2 k + 1 the pairs, then the real variables, then the phases. Errors
    // (refused): a word cannot hold exponents up to `largest` in every field.
    OuterKeysOf(int pairs, int reals, int phases, int largest);

    static constexpr Word imaginary = 1;
    [[nodiscard]] int fields() const { return static_cast<int>(first_phase_ + phases_); }
    [[nodiscard]] Word power(int field, int exponent) const { // checked
        const Word key = static_cast<Word>(std::int64_t{exponent}) << shift(field);
        return require_safe(key, exponent);
    }
    [[nodiscard]] int exponent(Word key, int field) const;
    // Drops the i^2 that a product of keys may hold; true: the sign of the coefficient changes.
    static bool take_square_of_i(Word& key) {
        const bool minus = (key & 2U) != 0;
        key &= ~Word{2};
        return minus;
    }
    [[nodiscard]] static bool has_i(Word key) { return (key & 1U) != 0; }
    // Pairs swapped, phases inverted; i is left: its sign is a matter of the coefficient.
    [[nodiscard]] Word mirror(Word key) const {
        const Word swapped = ((key & first_halves_) << bits_) | ((key & second_halves_) >> bits_);
        const Word low = swapped | (key & kept_);
        if (phases_ == 0) return low;
        return low - (key & ~(first_halves_ | second_halves_ | kept_));
    }
    // Refuses an unsafe key. (The product of two safe keys does not overflow into another field.)
    void require_safe(Word key) const {
        if (((key + quarters_) & guards_) != 0) overflow();
    }

private:
    [[nodiscard]] int shift(int field) const { return 2 + bits_ * field; }
    [[nodiscard]] Word require_safe(Word key, int exponent) const;
    [[noreturn]] void overflow() const;

    int bits_, first_phase_, phases_;
    Word first_halves_ = 0, second_halves_ = 0; // fields of the pairs
    Word kept_ = 3;                             // i and real variables
    Word quarters_ = 0, guards_ = 0; // an exponent is safe below half of its field (phases: a quarter)
};

using OuterKey = std::uint64_t;
using OuterKeys = OuterKeysOf<OuterKey>;
__extension__ using WideKey = unsigned __int128;

} // namespace resonform
