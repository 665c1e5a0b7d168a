// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of polynomials where others are positive.
#include "algebra/signs/polynomial_signs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace resonform {
namespace {

std::string text(const SignSet& set) {
    return std::string(set.negative ? "-" : "") + (set.zero ? "0" : "") + (set.positive ? "+" : "");
}

class PolynomialSignsTest : public ::testing::Test {
protected:
    using Coefficients = std::vector<int>; // of 1, x, x^2, ...

    Packed of_x(const Coefficients& coefficients) const {
        Packed sum(context);
        for (std::size_t k = 0; k < coefficients.size(); ++k)
            sum = sum + Packed(context, coefficients[k]) * x.raised(k);
        return sum;
    }
    std::string signs(const Coefficients& p, const std::vector<Coefficients>& conditions = {}) const {
        std::vector<Packed> positive;
        for (const Coefficients& c : conditions) positive.push_back(of_x(c));
        return text(PolynomialSigns(positive, {}).of(of_x(p)));
    }
    std::string signs(const Packed& p, const std::vector<Packed>& positive) const {
        return text(PolynomialSigns(positive, {}).of(p));
    }
    Packed number(int n) const { return Packed(context, n); }
    Packed generator(slong k) const {
        Packed result(context);
        fmpz_mpoly_gen(result.get(), k, context.get());
        return result;
    }

    PolynomialContext context{3};
    Packed x = generator(0), y = generator(1), z = generator(2);
};

TEST_F(PolynomialSignsTest, OfKnownPolynomialsInOneVariable) {
    EXPECT_EQ(signs({}), "0");
    EXPECT_EQ(signs({3}), "+");
    EXPECT_EQ(signs({-1, 0, 1}), "-0+");
    EXPECT_EQ(signs({1, 0, 1}), "+");
    EXPECT_EQ(signs({1, -2, 1}), "0+");
    EXPECT_EQ(signs({0, 0, 0, -1}), "-0+");
    EXPECT_EQ(signs({0, 1}, {{0, 1}}), "+");
    EXPECT_EQ(signs({-1, 1}, {{0, 1}, {-2, 0, 1}}), "+");
    EXPECT_EQ(signs({0, 1}, {{-2, 0, 1}}), "-+");
    EXPECT_EQ(signs({0, 1}, {{0, 0, 1}}), "-+");
    EXPECT_EQ(signs({-1, 0, 1}, {{-2, 0, 1}}), "+");
    EXPECT_EQ(signs({2, -3, 1}, {{-2, 0, 1}, {9, 0, -1}}), "-0+");
    EXPECT_EQ(signs({1}, {{-1}}), "");
    EXPECT_EQ(signs({-1, 1000}, {{0, 1}, {1, -1000}}), "-");
}

TEST_F(PolynomialSignsTest, OfKnownPolynomialsInSeveralVariables) {
    EXPECT_EQ(signs(x * x + y * y, {}), "0+");
    EXPECT_EQ(signs(x * x + y * y + number(1), {}), "+");
    EXPECT_EQ(signs(x * x + y * y, {y}), "+");
    EXPECT_EQ(signs(x * x + y * y + number(-2) * x * y, {}), "0+");
    EXPECT_EQ(signs(x * x + y * y + number(-2) * x * y, {x, y}), "0+");
    EXPECT_EQ(signs(x * x + y * y + (x * y).negative(), {x}), "+");
    EXPECT_EQ(signs(x * y + number(-1), {x, y}), "-0+");
    EXPECT_EQ(signs(x * y + number(-1), {x + number(-1), y + number(-1)}), "+");
    EXPECT_EQ(signs(x, {x * y + number(-1)}), "-+");
    EXPECT_EQ(signs(x + y, {x * y + number(-1)}), "-+");
    EXPECT_EQ(signs(z + y.negative(), {z + x.negative(), x + y.negative()}), "+");
    EXPECT_EQ(signs(z + x, {z + x.negative(), x + y.negative()}), "-0+");
    // Motzkin's polynomial is no sum of squares.
    const Packed motzkin = x.raised(4) * y.raised(2) + x.raised(2) * y.raised(4) + z.raised(6) +
                           number(-3) * (x * y * z).raised(2);
    EXPECT_EQ(signs(motzkin, {z}), "0+");
    EXPECT_EQ(signs(motzkin + z.raised(6).negative(), {z}), "-0+");
}

// x, y of one sign each, z = sqrt(x^2 + y).
TEST_F(PolynomialSignsTest, OfSquareRoots) {
    const auto with_root = [&](const Packed& p, const std::vector<Packed>& positive) {
        return text(PolynomialSigns(positive, {{2, x * x + y, number(1)}}).of(p));
    };
    EXPECT_EQ(with_root(z + x.negative(), {y, z}), "+");
    EXPECT_EQ(with_root(z + x.negative(), {y.negative(), x, z}), "-");
    EXPECT_EQ(with_root(z + number(-2) * x, {y, z}), "-0+");
    EXPECT_EQ(with_root(z * z + (x * x).negative(), {y, z}), "+");
}

// Roots known beforehand, some of them double, some of both polynomials.
TEST_F(PolynomialSignsTest, OfRandomProducts) {
    std::mt19937 random(7);
    const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
    const auto product = [&](const std::vector<int>& roots) { // of halves
        Packed p = number(1);
        for (const int root : roots) p = p * of_x({-root, 2});
        return p;
    };
    const auto sign = [](const std::vector<int>& roots, int quarters) {
        int result = 1;
        for (const int root : roots) result *= (quarters > 2 * root) - (quarters < 2 * root);
        return result;
    };
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<int> asked, given;
        for (int k = below(6); k > 0; --k) asked.push_back(below(9) - 4);
        for (int k = below(4); k > 0; --k) given.push_back(below(9) - 4);
        SignSet expected;
        for (int quarters = -20; quarters <= 20; ++quarters)
            if (sign(given, quarters) > 0) expected.insert(sign(asked, quarters));
        const SignSet found = PolynomialSigns({product(given)}, {}).of(product(asked));
        EXPECT_FALSE(expected.negative && !found.negative) << trial;
        EXPECT_FALSE(expected.zero && !found.zero) << trial;
        EXPECT_FALSE(expected.positive && !found.positive) << trial;
    }
}

// Quadratic and linear polynomials in three variables, at points of a grid.
TEST_F(PolynomialSignsTest, HoldAtPoints) {
    std::mt19937 random(5);
    const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
    const Packed monomials[] = {number(1), x, y, z, x * x, x * y, y * z, z * z};
    int known = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const auto draw = [&](int terms) {
            Packed sum(context);
            for (int k = 0; k < terms; ++k) sum = sum + number(below(7) - 3) * monomials[below(8)];
            return sum;
        };
        std::vector<Packed> positive{draw(2), draw(2), draw(3)};
        const Packed asked = draw(2) + draw(2) * draw(2) + number(below(2)) * (draw(2) * draw(2)).raised(2);
        const SignSet found = PolynomialSigns(positive, {}).of(asked);
        known += found == SignSet::all() ? 0 : 1;
        for (int n = 0; n < 60; ++n) {
            const Rational at[] = {Rational(below(17) - 8) / 3, Rational(below(17) - 8) / 3,
                                   Rational(below(17) - 8) / 3};
            const auto sign_there = [&](Packed p) {
                for (slong v = 0; v < 3; ++v) p = value_at(p, v, at[v]);
                return sign_of_number(p);
            };
            const bool inside = std::all_of(positive.begin(), positive.end(),
                                            [&](const Packed& p) { return sign_there(p) > 0; });
            EXPECT_TRUE(!inside || found.has(sign_there(asked))) << trial;
        }
    }
    EXPECT_GT(known, 20);
}

} // namespace
} // namespace resonform
