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
    // Without a branch, and without the call that comparing arrays is.
    friend bool operator==(const Monomial& a, const Monomial& b) {
        return ((a.word[0] ^ b.word[0]) | (a.word[1] ^ b.word[1]) | (a.word[2] ^ b.word[2]) |
                (a.word[3] ^ b.word[3])) == 0;
    }
    friend bool operator<(const Monomial& a, const Monomial& b) { return a.word < b.word; }
};

} // namespace resonform
