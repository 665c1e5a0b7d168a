// SPDX-License-Identifier: GPL-3.0-or-later
// The set of signs that a quantity may take; a sign outside the set is proved not to occur. + and * give
// the set for a sum or a product of two quantities.
#pragma once

#include <initializer_list>

namespace resonform {

struct SignSet {
    bool negative = false, zero = false, positive = false;

    static constexpr SignSet all() { return {true, true, true}; } // nothing is known
    static constexpr SignSet of(int sign) { return {sign<0, sign == 0, sign> 0}; }

    [[nodiscard]] constexpr bool empty() const { return !negative && !zero && !positive; }
    [[nodiscard]] constexpr bool has(int sign) const {
        return sign < 0 ? negative : sign > 0 ? positive : zero;
    }
    [[nodiscard]] constexpr bool is_positive() const { return positive && !zero && !negative; }
    [[nodiscard]] constexpr bool is_known() const { return negative + zero + positive == 1; }
    constexpr void insert(int sign) { (sign < 0 ? negative : sign > 0 ? positive : zero) = true; }
    [[nodiscard]] constexpr SignSet square() const { return {false, zero, negative || positive}; }

    friend constexpr bool operator==(const SignSet&, const SignSet&) = default;
    friend constexpr SignSet operator-(const SignSet& a) { return {a.positive, a.zero, a.negative}; }
    friend constexpr SignSet operator&(const SignSet& a, const SignSet& b) { // both are known
        return {a.negative && b.negative, a.zero && b.zero, a.positive && b.positive};
    }
    friend constexpr SignSet operator*(const SignSet& a, const SignSet& b) {
        SignSet product;
        for (const int s : {-1, 0, 1})
            for (const int t : {-1, 0, 1})
                if (a.has(s) && b.has(t)) product.insert(s * t);
        return product;
    }
    friend constexpr SignSet operator+(const SignSet& a, const SignSet& b) {
        const bool zero = (a.zero && b.zero) || (a.negative && b.positive) || (a.positive && b.negative);
        return {a.negative || b.negative, zero, a.positive || b.positive};
    }
};

} // namespace resonform
