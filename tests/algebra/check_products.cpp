// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of products over a common denominator, in one word, in two and in many, against plain rationals.
#include "algebra/ring/fractions.hpp"
#include "algebra/ring/products.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

namespace resonform {
namespace {

class RandomTerms {
public:
    explicit RandomTerms(unsigned seed, int most = 3) : random_(seed), most_(most) {}

    // Up to `count` terms in three fields, numerators of up to `bits` bits.
    Polynomial next(std::size_t count, int bits) { return next(count, bits, bits / 2); }
    Polynomial next(std::size_t count, int bits, int bits_below) {
        const Packing packing(4);
        std::vector<Term> terms;
        for (std::size_t k = 0; k < count; ++k) {
            const std::vector<int> exponents{small(), small(), 0, small()};
            const Integer numerator = number(bits), denominator = number(bits_below) + 1;
            terms.push_back({packing.pack(exponents),
                             Rational(random_() % 2 == 0 ? numerator : -numerator) / denominator});
        }
        return Polynomial::from_terms(std::move(terms));
    }
    Rational factor() { return Rational(static_cast<long>(random_() % 9) - 4) / (1 + random_() % 5); }

private:
    int small() { return static_cast<int>(random_() % static_cast<unsigned>(2 * most_ + 1)) - most_; }
    Integer number(int bits) {
        Integer n = 0;
        for (int done = 0; done < bits; done += 16)
            n = cln::ash(n, 16) + Integer(static_cast<unsigned long>(random_() % 65536));
        return n;
    }

    std::mt19937 random_;
    int most_;
};

struct Summand {
    Rational factor;
    Polynomial left, right;
};

Polynomial by_definition(const std::vector<Summand>& summands) {
    std::map<Monomial, Rational> sum;
    for (const Summand& s : summands)
        for (const Term& a : s.left.terms())
            for (const Term& b : s.right.terms()) {
                Rational& c = sum[a.monomial + b.monomial];
                c = c + s.factor * a.coefficient * b.coefficient;
            }
    std::vector<Term> terms;
    for (const auto& [monomial, c] : sum) terms.push_back({monomial, c});
    return Polynomial::from_terms(std::move(terms));
}

Polynomial by_kernel(const std::vector<Summand>& summands, const Packing* packing = nullptr) {
    std::vector<FractionProduct> products;
    for (const Summand& s : summands)
        products.push_back({&s.left.fractions(), &s.right.fractions(), s.factor});
    return Polynomial::from_fractions(sum_of_products(products, packing));
}

// Large enough for two threads. The exponents of one field are even throughout, so that it divides nothing.
TEST(Products, AreTheSameInTwoThreads) {
    const Packing packing(4);
    for (const int bits : {8, 40, 200}) {
        RandomTerms random(21, 9);
        std::vector<Summand> summands;
        for (int k = 0; k < 3; ++k)
            summands.push_back({random.factor(), random.next(400, bits, 0), random.next(300, bits, 0)});
        EXPECT_EQ(by_kernel(summands, &packing), by_kernel(summands)) << bits << " bits";
        std::vector<Term> squares;
        for (const Term& t : summands[0].left.terms())
            squares.push_back({t.monomial + t.monomial, t.coefficient});
        for (Summand& s : summands) s.right = Polynomial::from_terms(squares);
        EXPECT_EQ(by_kernel(summands, &packing), by_kernel(summands)) << bits << " bits, even exponents";
    }
}

TEST(Products, EqualTheirDefinitionAtEveryWidth) {
    RandomTerms random(20);
    for (const int bits : {4, 16, 32, 48, 64, 80, 128, 200, 640})
        for (const std::size_t count : {1U, 2U, 7U, 40U}) {
            std::vector<Summand> summands;
            for (int k = 0; k < 4; ++k)
                summands.push_back({random.factor(), random.next(count, bits), random.next(count, bits / 2)});
            EXPECT_EQ(by_kernel(summands), by_definition(summands)) << bits << " bits, " << count;
        }
}

// Sums at the very edge of a word, of two words, of three: carries and signs must not be lost.
TEST(Products, KeepEveryBit) {
    const Packing packing(1);
    const Monomial x = packing.power(0, 1), one{};
    for (const int bits : {31, 32, 62, 63, 64, 65, 95, 96, 127, 128, 191, 192}) {
        const Integer top = cln::ash(Integer(1), bits);
        for (const Integer& a : {Integer(top - 1), top, Integer(top + 1)}) {
            for (const Integer& b : {Integer(top - 1), Integer(1 - top), Integer(-top)}) {
                const Polynomial left = Polynomial::from_terms({{one, a}, {x, a}});
                const Polynomial right = Polynomial::from_terms({{one, b}, {x, -b}});
                const std::vector<Summand> summands{{1, left, right}, {1, left, left}, {-1, right, right}};
                EXPECT_EQ(by_kernel(summands), by_definition(summands)) << bits;
            }
        }
    }
}

TEST(Products, ThatCancelAreEmpty) {
    RandomTerms random(3);
    const Polynomial a = random.next(12, 100), b = random.next(12, 100);
    EXPECT_TRUE(by_kernel({{Rational(2) / 3, a, b}, {Rational(-2) / 3, b, a}}).empty());
    EXPECT_TRUE(by_kernel({{0, a, b}}).empty());
    EXPECT_TRUE(by_kernel({}).empty());
}

// One term times many, factors and denominators up to the edges of a word and beyond.
TEST(Products, OfOneTermAndOfLargeFactors) {
    RandomTerms random(11);
    for (const int bits : {3, 30, 61, 62, 63, 64, 100})
        for (const int more : {1, 59, 60, 61, 62, 63, 65, 130}) {
            const Rational factor =
                (cln::ash(Integer(1), more) + 1) / Rational(cln::ash(Integer(1), bits) - 1);
            const Polynomial a = random.next(1, bits), b = random.next(9, bits), c = random.next(5, more);
            for (const Rational& f : {factor, Rational(-factor), Rational(1 / factor)})
                for (const std::vector<Summand>& sum :
                     {std::vector<Summand>{{f, a, b}}, {{f, b, a}, {1, c, b}, {-f, c, c}}})
                    EXPECT_EQ(by_kernel(sum), by_definition(sum)) << bits << " bits, " << more;
        }
}

TEST(Products, TermsWithEqualMonomialsAreCollected) {
    RandomTerms random(12);
    for (const int bits : {8, 62, 64, 150}) {
        const Polynomial p = random.next(20, bits);
        Fractions twice = p.fractions();
        for (std::size_t k = 0; k < p.size(); ++k)
            for (int n = 0; n < 4; ++n) twice.append(p.fractions().monomials[k], p.fractions(), k);
        EXPECT_EQ(Polynomial::from_fractions(collected(twice)), Rational(5) * p);
    }
}

TEST(Fractions, AndTermsAreOneThing) {
    RandomTerms random(5);
    for (const int bits : {8, 40, 64, 150}) {
        const Polynomial p = random.next(20, bits);
        EXPECT_EQ(Polynomial::from_fractions(p.fractions()), p);
        EXPECT_EQ(to_terms(p.fractions()), p.terms());
        EXPECT_EQ(p.size(), p.terms().size());
    }
}

TEST(Fractions, AreCanonical) {
    const Packing packing(1);
    const Polynomial p = Polynomial::from_terms({{packing.power(0, 2), Rational(2) / 3}, {Monomial{}, -6}});
    const Polynomial q = Rational(1) / 4 * (Rational(4) * p);
    EXPECT_EQ(q, p);
    EXPECT_EQ(q.fractions().denominator, 3);
    EXPECT_EQ(q.fractions().limbs, 1U);
    EXPECT_EQ(q.fractions().bits(), 5U); // 18
    EXPECT_EQ(q.fractions().negative, (std::vector<std::uint8_t>{1, 0}));
}

} // namespace
} // namespace resonform
