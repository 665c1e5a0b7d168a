// SPDX-License-Identifier: GPL-3.0-or-later
// One elimination: ranks, what cannot be decided, and the choice of pivots.
#include "algebra/number/elimination.hpp"
#include "algebra/number/modular.hpp"
#include "algebra/number/rational_matrix.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

using Rows = std::vector<std::vector<Rational>>;

TEST(Elimination, ReducesRowsOfAnyRank) {
    Rows rows{{0, 2, 4, 2}, {1, 1, 0, 3}, {1, 3, 4, 5}};
    EXPECT_EQ(reduce_rows(rows, 3, Rationals()), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(rows, (Rows{{1, 0, -2, 2}, {0, 1, 2, 1}, {0, 0, 0, 0}}));
    Rows singular{{1, 2, 1, 0}, {2, 4, 0, 1}};
    EXPECT_FALSE(solve_rows(singular, Rationals()));
    Rows none;
    EXPECT_TRUE(solve_rows(none, Rationals()));
}

TEST(Elimination, InvertsModuloAPrime) {
    const PrimeField field(10007);
    std::mt19937_64 random(1);
    for (std::size_t n = 1; n < 7; ++n) {
        std::vector<std::vector<Residue>> a(n);
        for (auto& row : a)
            for (std::size_t k = 0; k < n; ++k) row.push_back(field.random_unit(random));
        const auto inverse = inverse_rows(a, Residue{1}, Residues{field});
        ASSERT_TRUE(inverse);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                Residue sum = 0;
                for (std::size_t k = 0; k < n; ++k)
                    sum = field.add(sum, field.multiply(a[i][k], (*inverse)[k][j]));
                EXPECT_EQ(sum, i == j ? 1U : 0U);
            }
    }
}

// Rationals of which 7 can be told neither zero nor non-zero, and 5 is the pivot that is wanted.
struct Doubtful : Rationals {
    static Zero zero(const Rational& a) { return a == 7 ? Zero::unknown : Rationals::zero(a); }
    static bool settles(const Rational& a) { return a == 5; }
};

TEST(Elimination, DividesByNothingThatMayBeZero) {
    Rows rows{{7, 1}, {0, 2}};
    EXPECT_EQ(reduce_rows(rows, 2, Doubtful()), std::nullopt);
    rows = {{7, 1}, {3, 2}};
    EXPECT_EQ(reduce_rows(rows, 2, Doubtful()), (std::vector<std::size_t>{0, 1}));
    rows = {{3, 1}, {5, 10}};
    ASSERT_TRUE(reduce_rows(rows, 1, Doubtful()));
    EXPECT_EQ(rows, (Rows{{1, 2}, {0, -5}}));
}

} // namespace
} // namespace resonform
