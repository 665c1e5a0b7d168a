// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of prime fields, on small primes exhaustively and on random large ones.
#include "algebra/number/modular.hpp"

#include <flint/ulong_extras.h>
#include <gtest/gtest.h>

#include <vector>

namespace resonform {
namespace {

const std::vector<std::uint64_t> small_primes{3, 5, 13, 17, 37, 97, 163, 193, 257, 271};

TEST(Primality, agrees_with_the_sieve) {
    std::vector<bool> composite(20000, false);
    for (std::size_t n = 2; n < composite.size(); ++n) {
        EXPECT_EQ(n_is_prime(n), !composite[n]) << n;
        for (std::size_t m = 2 * n; m < composite.size(); m += n) composite[m] = true;
    }
    EXPECT_FALSE(n_is_prime(0));
    EXPECT_FALSE(n_is_prime(1));
}

TEST(Primality, knows_strong_pseudoprimes_and_large_primes) {
    EXPECT_FALSE(n_is_prime(3215031751ULL));          // strong pseudoprime to 2, 3, 5, 7
    EXPECT_FALSE(n_is_prime(3825123056546413051ULL)); // to 2, ..., 23
    EXPECT_TRUE(n_is_prime(2305843009213693951ULL));  // 2^61 - 1
    EXPECT_FALSE(n_is_prime(2305843009213693949ULL));
    EXPECT_TRUE(n_is_prime(18446744073709551557ULL)); // the largest below 2^64
}

TEST(Primality, random_primes_are_of_the_promised_kind_and_reproducible) {
    std::mt19937_64 random(7), again(7);
    for (int n = 0; n < 20; ++n) {
        const std::uint64_t p = random_prime(random);
        EXPECT_TRUE(n_is_prime(p));
        EXPECT_EQ(p % 4, 1U);
        EXPECT_EQ(p >> 60, 1U);
        EXPECT_EQ(p, random_prime(again));
    }
}

TEST(PrimeField, is_a_field) {
    std::mt19937_64 random(11);
    for (int n = 0; n < 200; ++n) {
        const PrimeField f(n < 100 ? random_prime(random) : small_primes[static_cast<std::size_t>(n) % 10]);
        const Residue a = f.random_unit(random), b = f.random_unit(random), c = f.random_unit(random);
        EXPECT_EQ(f.multiply(a, f.inverse(a)), 1U) << a << " mod " << f.prime();
        EXPECT_EQ(f.multiply(a, f.add(b, c)), f.add(f.multiply(a, b), f.multiply(a, c)));
        EXPECT_EQ(f.subtract(f.add(a, b), b), a);
        EXPECT_EQ(f.add(a, f.negate(a)), 0U);
        EXPECT_EQ(f.power(a, -5), f.inverse(f.power(a, 5)));
        EXPECT_EQ(f.power(a, static_cast<std::int64_t>(f.prime()) - 1), 1U);
        if (f.prime() % 4 == 1) {
            EXPECT_EQ(f.multiply(f.imaginary_unit(), f.imaginary_unit()), f.negate(1));
        }
    }
}

TEST(PrimeField, rationals_map_homomorphically) {
    std::mt19937_64 random(3);
    const PrimeField f(random_prime(random));
    const Rational a = parse_rational("-123456789012345678901234567890/7"), b = parse_rational("22/91");
    EXPECT_EQ(f.add(*f.from(a), *f.from(b)), *f.from(a + b));
    EXPECT_EQ(f.multiply(*f.from(a), *f.from(b)), *f.from(a * b));
    EXPECT_EQ(*f.from(Rational(-1)), f.prime() - 1);
    EXPECT_FALSE(PrimeField(13).from(parse_rational("1/26")).has_value());
}

TEST(PrimeField, a_root_is_found_exactly_when_there_is_one) {
    for (const std::uint64_t p : small_primes) {
        const PrimeField f(p);
        for (int k = 1; k <= 12; ++k) {
            std::vector<bool> is_power(p, false);
            for (Residue x = 0; x < p; ++x) is_power[f.power(x, k)] = true;
            for (Residue a = 0; a < p; ++a) {
                const std::optional<Residue> x = f.root(a, k);
                ASSERT_EQ(x.has_value(), is_power[a]) << a << "^(1/" << k << ") mod " << p;
                if (x) {
                    EXPECT_EQ(f.power(*x, k), a) << a << "^(1/" << k << ") mod " << p;
                }
            }
        }
    }
}

TEST(PrimeField, squares_are_told_as_by_powers) {
    std::mt19937_64 random(8);
    for (int n = 0; n < 200; ++n) {
        const PrimeField f(n % 2 == 0 ? random_prime(random) : small_primes.back());
        const Residue a = f.random_unit(random);
        EXPECT_EQ(f.is_square(a), f.power(a, static_cast<std::int64_t>((f.prime() - 1) / 2)) == 1);
        EXPECT_TRUE(f.is_square(f.multiply(a, a)));
    }
}

TEST(PrimeField, powers_modulo_large_primes_have_roots) {
    std::mt19937_64 random(5);
    for (int n = 0; n < 100; ++n) {
        const PrimeField f(random_prime(random));
        const int k = 2 + n % 23;
        const Residue a = f.power(f.random_unit(random), k);
        const std::optional<Residue> x = f.root(a, k);
        ASSERT_TRUE(x.has_value()) << k << " mod " << f.prime();
        EXPECT_EQ(f.power(*x, k), a) << k << " mod " << f.prime();
    }
}

} // namespace
} // namespace resonform
