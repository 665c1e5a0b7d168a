// SPDX-License-Identifier: GPL-3.0-or-later
// Where the exponents stand in a Monomial. A field holds one signed exponent; a word is the sum of
// e_f 2^(bits f) modulo 2^64 over its fields, so that adding words adds exponents, borrows included.
//
//   generators   up to 16   20   24   28   32
//   bits               16   12   10    9    8
//
// Every operand of a product must be `safe`: |e| <= largest() = 2^(bits-2) - 1, a quarter of the field.
// The sum of two safe monomials never overflows a field, and being unsafe is seen at its next use:
// overflow cannot be silent.
#pragma once

#include "algebra/ring/monomial.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace resonform {

class Packing {
public:
    static constexpr int most_fields = 32;

    explicit Packing(int fields = most_fields); // fields <= most_fields

    // Field f stands in word f / fields_per_word().
    [[nodiscard]] int fields_per_word() const { return per_word_; }
    [[nodiscard]] int fields() const { return fields_per_word() * static_cast<int>(Monomial{}.word.size()); }
    [[nodiscard]] int largest() const { return (1 << (bits_ - 2)) - 1; }

    // field < fields()
    [[nodiscard]] int exponent(const Monomial& m, int field) const {
        const std::uint64_t biased = m.word[word_of(field)] + half_;
        return static_cast<int>((biased >> shift_of(field)) & mask_) - (1 << (bits_ - 1));
    }

    // visit(f, exponent) for the fields_per_word() fields of one word.
    template <class Visit> void visit_word(const Monomial& m, int word, Visit visit) const {
        std::uint64_t biased = m.word[static_cast<std::size_t>(word)] + half_;
        if (bits_ == 16) { // most rings: without a loop
            for (int f = 0; f < 4; ++f, biased >>= 16)
                visit(f, static_cast<int>(biased & 0xffff) - (1 << 15));
            return;
        }
        for (int f = 0; f < per_word_; ++f, biased >>= bits_)
            visit(f, static_cast<int>(biased & mask_) - (1 << (bits_ - 1)));
    }

    // -2^(bits-2) <= e < 2^(bits-2) in all fields: with a quarter added no field has its top bit set.
    [[nodiscard]] bool safe(const Monomial& m) const {
        std::uint64_t top = 0;
        for (std::uint64_t w : m.word) top |= (w + quarter_) & half_;
        return top == 0;
    }
    // Throws Error(refused) unless safe(m).
    void require_safe(const Monomial& m) const {
        if (!safe(m)) overflow();
    }

    // The monomial of one field; refused when |exponent| > largest().
    [[nodiscard]] Monomial power(int field, long exponent) const;
    [[nodiscard]] Monomial pack(const std::vector<int>& exponents) const;
    [[nodiscard]] std::vector<int> unpack(const Monomial& m, int fields) const;
    // m^factor, refused on overflow.
    [[nodiscard]] Monomial scaled(const Monomial& m, long factor) const;

private:
    [[nodiscard]] std::size_t word_of(int field) const { return words_[static_cast<std::size_t>(field)]; }
    [[nodiscard]] int shift_of(int field) const { return shifts_[static_cast<std::size_t>(field)]; }
    [[noreturn]] void overflow() const;

    int per_word_;
    int bits_;
    std::array<std::uint8_t, most_fields> words_, shifts_; // by field: divisions would take longer
    std::uint64_t mask_;
    std::uint64_t half_ = 0;    // 2^(bits-1) in every field
    std::uint64_t quarter_ = 0; // 2^(bits-2) in every field
};

} // namespace resonform
