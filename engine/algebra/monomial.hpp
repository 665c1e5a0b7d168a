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

} // namespace resonform
