// SPDX-License-Identifier: GPL-3.0-or-later
// Montgomery's form of residues, for long sums of products: x is held as x 2^64 mod p.
#pragma once

#include "algebra/number/modular.hpp"

namespace resonform {

class Montgomery {
public:
    explicit Montgomery(const PrimeField& field) : field_(field), prime_(field.prime()) {
        std::uint64_t inverse =
            prime_; // Newton's iteration: each step doubles the correct bits of 1/p mod 2^64
        for (int step = 0; step < 6; ++step) inverse *= 2 - prime_ * inverse;
        minus_inverse_ = ~inverse + 1;
        const Residue base = field.from(std::int64_t{1} << 32);
        const Residue once = field.multiply(base, base); // 2^64
        square_ = field.multiply(once, once);
        unit_ = once;
    }

    [[nodiscard]] Residue enter(Residue x) const { return multiply(x, square_); }
    [[nodiscard]] Residue leave(Residue x) const { return reduce(x); }
    [[nodiscard]] Residue multiply(Residue a, Residue b) const { return reduce(Wide{a} * b); }
    [[nodiscard]] Residue negate(Residue a) const { return a == 0 ? 0 : prime_ - a; }
    [[nodiscard]] Residue add(Residue a, Residue b) const { return field_.add(a, b); }
    [[nodiscard]] Residue subtract(Residue a, Residue b) const { return field_.subtract(a, b); }
    [[nodiscard]] Residue from(std::int64_t n) const { return enter(field_.from(n)); }
    [[nodiscard]] Residue inverse(Residue a) const { return enter(field_.inverse(leave(a))); } // a != 0
    [[nodiscard]] Residue power(Residue a, std::uint64_t exponent) const {
        return power_of(*this, a, exponent);
    }
    [[nodiscard]] const PrimeField& field() const { return field_; }

    __extension__ using Wide = unsigned __int128;
    // Adds a b to a sum that stays below p 2^64, which reduce() takes.
    void accumulate(Wide& sum, Residue a, Residue b) const {
        sum += Wide{a} * b;
        if (static_cast<std::uint64_t>(sum >> 64) >= prime_) sum -= Wide{prime_} << 64;
    }
    // x mod p for any x.
    [[nodiscard]] Residue whole(Wide x) const {
        const Residue high = multiply(static_cast<std::uint64_t>(x >> 64), square_);
        return field_.add(high, multiply(static_cast<std::uint64_t>(x), unit_));
    }
    // x 2^-64 mod p for x < p 2^64.
    [[nodiscard]] Residue reduce(Wide x) const {
        const std::uint64_t multiple = static_cast<std::uint64_t>(x) * minus_inverse_;
        const auto rest = static_cast<std::uint64_t>((x + Wide{multiple} * prime_) >> 64);
        return rest >= prime_ ? rest - prime_ : rest;
    }

private:
    PrimeField field_;
    std::uint64_t prime_;
    std::uint64_t minus_inverse_; // -1/p mod 2^64
    Residue square_, unit_;       // 2^128, 2^64 mod p
};

} // namespace resonform
