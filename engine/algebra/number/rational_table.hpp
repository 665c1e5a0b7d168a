// SPDX-License-Identifier: GPL-3.0-or-later
// Rational numbers by id: equal rationals have one id, and the id of -q follows from that of q.
#pragma once

#include "algebra/number/number.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace resonform {

using RationalId = std::uint32_t;

class RationalTable {
public:
    static constexpr RationalId zero = 0, one = 2, minus_one = 3;

    RationalTable();

    RationalId intern(const Rational& value);
    [[nodiscard]] const Rational& value(RationalId id) const { return values_[id]; }
    // 2, 3 | 4, 5 | ...: a number and its negative, the one that was asked for first in front.
    [[nodiscard]] static RationalId negate(RationalId id) { return id == zero ? zero : id ^ 1U; }
    [[nodiscard]] static bool is_minus(RationalId id) { return (id & 1U) != 0; }
    RationalId multiply(RationalId a, RationalId b) {
        if (a == zero || b == zero) return zero;
        if (a < 4) return a == one ? b : b ^ 1U;
        if (b < 4) return b == one ? a : a ^ 1U;
        return remembered(products_, a, b, true);
    }
    RationalId add(RationalId a, RationalId b) {
        if (a == zero) return b;
        if (b == zero) return a;
        if ((a ^ b) == 1U) return zero;
        return remembered(sums_, a, b, false);
    }
    [[nodiscard]] std::size_t size() const { return values_.size(); } // ids are below

private:
    struct Hash {
        std::size_t operator()(const Rational& q) const { return cln::equal_hashcode(q); }
    };
    struct Remembered {
        std::uint64_t operands = 0;
        RationalId result = 0;
    };
    static constexpr std::size_t memory = 4096; // a power of two
    using Memory = std::array<Remembered, memory>;
    RationalId remembered(Memory& results, RationalId a, RationalId b, bool multiplied);

    std::vector<Rational> values_;
    std::unordered_map<Rational, RationalId, Hash> ids_;
    Memory products_{}, sums_{};
};

} // namespace resonform
