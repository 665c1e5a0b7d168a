// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic modulo a random prime: the field in which a certificate substitutes.
//
//   PrimeField f(13);  f.multiply(5, 8) = 1;  f.inverse(5) = 8;  f.root(12, 2) = 5 or 8
#pragma once

#include "algebra/number/number.hpp"
#include "algebra/number/zero.hpp"

#include <flint/nmod.h>

#include <cstdint>
#include <optional>
#include <random>

namespace resonform {

using Residue = std::uint64_t; // 0 <= value < prime

// Uniform among the primes 2^60 < p < 2^61 with p = 1 mod 4, so that -1 has a square root.
// There are more than `primes_to_choose_from` of them.
std::uint64_t random_prime(std::mt19937_64& random);
inline constexpr double primes_to_choose_from = 1.3e16; // (pi(2^61) - pi(2^60)) / 2 = 1.37e16

// The field of residues modulo a prime below 2^62. Residues that are handed in must be reduced.
class PrimeField {
public:
    explicit PrimeField(std::uint64_t prime) { nmod_init(&modulus_, prime); }

    [[nodiscard]] std::uint64_t prime() const { return modulus_.n; }
    [[nodiscard]] const nmod_t& modulus() const { return modulus_; } // for FLINT
    [[nodiscard]] Residue add(Residue a, Residue b) const { return _nmod_add(a, b, modulus_); }
    [[nodiscard]] Residue subtract(Residue a, Residue b) const { return _nmod_sub(a, b, modulus_); }
    [[nodiscard]] Residue negate(Residue a) const { return nmod_neg(a, modulus_); }
    [[nodiscard]] Residue multiply(Residue a, Residue b) const { return nmod_mul(a, b, modulus_); }
    [[nodiscard]] Residue power(Residue a, std::int64_t exponent) const; // exponent < 0: a != 0
    [[nodiscard]] Residue inverse(Residue a) const;                      // a != 0
    [[nodiscard]] Residue from(std::int64_t n) const;
    // nullopt where the prime divides the denominator.
    [[nodiscard]] std::optional<Residue> from(const Rational& value) const;
    [[nodiscard]] bool is_square(Residue a) const; // the prime is odd
    // Some x with x^k = a, or nullopt if there is none. The cost grows with the largest prime factor
    // of k, which divides p - 1.
    [[nodiscard]] std::optional<Residue> root(Residue a, int k) const;
    // A root of -1; precondition: p = 1 mod 4.
    [[nodiscard]] Residue imaginary_unit() const;
    // Uniform among 1, ..., p - 1.
    [[nodiscard]] Residue random_unit(std::mt19937_64& random) const;

    __extension__ using Wide = unsigned __int128;
    // A sum of products, reduced once.
    class ProductSum {
    public:
        explicit ProductSum(const PrimeField& field)
            : field_(&field), square_(Wide{field.prime()} * field.prime()) {}
        void add(Residue a, Residue b) {
            total_ += Wide{a} * b; // below 2 p^2 < 2^125
            if (total_ >= square_) total_ -= square_;
        }
        [[nodiscard]] Residue value() const { return field_->reduce(total_); }

    private:
        const PrimeField* field_;
        Wide square_, total_ = 0;
    };

private:
    // x mod p for x < p^2
    [[nodiscard]] Residue reduce(Wide x) const {
        Residue rest = 0;
        NMOD_RED2(rest, static_cast<Residue>(x >> 64), static_cast<Residue>(x), modulus_);
        return rest;
    }

    [[nodiscard]] Residue raise(Residue a, std::uint64_t exponent) const;
    [[nodiscard]] std::optional<Residue> prime_power_root(Residue a, std::uint64_t factor, int times) const;
    // The generator of the subgroup of order factor^times, with p - 1 = factor^times * cofactor.
    [[nodiscard]] Residue sylow_generator(std::uint64_t factor, std::uint64_t cofactor) const;

    nmod_t modulus_;
};

// The field of elimination.hpp.
struct Residues {
    const PrimeField& field;

    static Zero zero(Residue a) { return a == 0 ? Zero::yes : Zero::no; }
    static bool is_zero(Residue a) { return a == 0; }
    static bool settles(Residue /*a*/) { return true; }
    [[nodiscard]] std::optional<Residue> divisor(Residue a) const { return field.inverse(a); }
    [[nodiscard]] Residue over(Residue a, Residue inverse) const { return field.multiply(a, inverse); }
    [[nodiscard]] Residue without(Residue a, Residue factor, Residue b) const {
        return field.subtract(a, field.multiply(factor, b));
    }
};

// Montgomery's form of residues, for long sums of products: x is held as x 2^64 mod p.
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
        Residue result = unit_;
        for (; exponent != 0; exponent >>= 1) {
            if ((exponent & 1) != 0) result = multiply(result, a);
            a = multiply(a, a);
        }
        return result;
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
