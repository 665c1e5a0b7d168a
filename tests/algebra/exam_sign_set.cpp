// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of polynomials in one variable under conditions.
#include "algebra/number/sign_set.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace resonform {
namespace {

std::string signs(const UnivariatePolynomial& p, const std::vector<SignCondition>& conditions = {}) {
    const SignSet set = signs_where(p, conditions);
    return std::string(set.negative ? "-" : "") + (set.zero ? "0" : "") + (set.positive ? "+" : "");
}

TEST(SignSet, OfKnownPolynomials) {
    EXPECT_EQ(signs({}), "0");
    EXPECT_EQ(signs({3}), "+");
    EXPECT_EQ(signs({-1, 0, 1}), "-0+");
    EXPECT_EQ(signs({1, 0, 1}), "+");
    EXPECT_EQ(signs({1, -2, 1}), "0+");
    EXPECT_EQ(signs({0, 0, 0, -1}), "-0+");
    EXPECT_EQ(signs({0, 1}, {{{0, 1}, true}}), "+");
    EXPECT_EQ(signs({0, 1}, {{{0, 1}, false}}), "0+");
    EXPECT_EQ(signs({-1, 1}, {{{0, 1}, true}, {{-2, 0, 1}, true}}), "+");
    EXPECT_EQ(signs({0, 1}, {{{-2, 0, 1}, true}}), "-+");
    EXPECT_EQ(signs({-2, 0, 1}, {{{2, 0, -1}, false}, {{-2, 0, 1}, false}}), "0"); // at +-sqrt(2) alone
    EXPECT_EQ(signs({1}, {{{-1, 0, -1}, true}}), "");
    EXPECT_EQ(signs({-1, 1000}, {{{0, 1}, true}, {{1, -1000}, true}}), "-");
}

// Roots known beforehand, some of them double, some of both polynomials.
TEST(SignSet, OfRandomProducts) {
    std::mt19937 random(7);
    const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
    const auto product = [&](const std::vector<int>& roots) { // of halves
        UnivariatePolynomial p{1};
        for (const int root : roots) {
            UnivariatePolynomial longer(p.size() + 1, 0);
            for (std::size_t k = 0; k < p.size(); ++k) {
                longer[k + 1] = longer[k + 1] + p[k];
                longer[k] = longer[k] - Rational(root) / 2 * p[k];
            }
            p = longer;
        }
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
        const bool strict = below(2) == 0;
        SignSet expected;
        for (int quarters = -20; quarters <= 20; ++quarters)
            if (const int s = sign(given, quarters); s > 0 || (s == 0 && !strict))
                expected.insert(sign(asked, quarters));
        const SignSet found = signs_where(product(asked), {{product(given), strict}});
        EXPECT_EQ(found.negative, expected.negative) << trial;
        EXPECT_EQ(found.zero, expected.zero) << trial;
        EXPECT_EQ(found.positive, expected.positive) << trial;
    }
}

} // namespace
} // namespace resonform
