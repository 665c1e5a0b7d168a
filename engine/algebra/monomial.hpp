// SPDX-License-Identifier: GPL-3.0-or-later
// A monomial is a packed vector of signed exponents: one additive key of 256 bits. Multiplying two
// monomials is adding their words. Only a Ring knows the width of the fields and what they mean.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace resonform {

struct Monomial {
    std::array<std::uint64_t, 4> word{};

    friend Monomial operator+(Monomial a, const Monomial& b) {
        for (std::size_t i = 0; i < a.word.size(); ++i) a.word[i] += b.word[i];
        return a;
    }
    friend Monomial operator-(Monomial a, const Monomial& b) {
        for (std::size_t i = 0; i < a.word.size(); ++i) a.word[i] -= b.word[i];
        return a;
    }
    friend bool operator==(const Monomial&, const Monomial&) = default;
    friend bool operator<(const Monomial& a, const Monomial& b) { return a.word < b.word; }
};

// Both halves of a 128-bit product are folded together, so that fields at the top of a word reach the
// low bits, which choose the slot of a hash table.
struct MonomialHash {
    std::size_t operator()(const Monomial& m) const noexcept {
        __extension__ using Wide = unsigned __int128;
        std::uint64_t h = 0x9E3779B97F4A7C15ULL;
        for (std::uint64_t w : m.word) {
            const Wide product = static_cast<Wide>(h ^ w) * 0xBF58476D1CE4E5B9ULL;
            h = static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
        }
        return static_cast<std::size_t>(h);
    }
};

} // namespace resonform
