// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of Moore and Penrose, with measures of rows and columns.
#include "algebra/number/rational_matrix.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

bool equal(const RationalMatrix& a, const RationalMatrix& b) {
    for (std::size_t r = 0; r < a.rows(); ++r)
        for (std::size_t c = 0; c < a.columns(); ++c)
            if (a.at(r, c) != b.at(r, c)) return false;
    return a.rows() == b.rows() && a.columns() == b.columns();
}

// Of rank at most `rank`.
RationalMatrix random_matrix(std::mt19937& random, std::size_t rows, std::size_t columns, std::size_t rank) {
    const auto fill = [&](RationalMatrix m) {
        for (std::size_t r = 0; r < m.rows(); ++r)
            for (std::size_t c = 0; c < m.columns(); ++c)
                m.at(r, c) =
                    Rational(static_cast<int>(random() % 7) - 3) / (1 + static_cast<int>(random() % 3));
        return m;
    };
    return multiply(fill(RationalMatrix(rows, rank)), fill(RationalMatrix(rank, columns)));
}

// G A with G diagonal is symmetric.
bool is_self_adjoint(RationalMatrix a, const std::vector<Rational>& measure) {
    for (std::size_t r = 0; r < a.rows(); ++r)
        for (std::size_t c = 0; c < a.columns(); ++c) a.at(r, c) = a.at(r, c) * measure[r];
    return equal(a, transposed(a));
}

TEST(RationalMatrix, PseudoInverseObeysItsLaws) {
    std::mt19937 random(3);
    for (std::size_t rows = 1; rows <= 4; ++rows)
        for (std::size_t columns = 1; columns <= 4; ++columns)
            for (std::size_t rank = 1; rank <= 3; ++rank) {
                const RationalMatrix b = random_matrix(random, rows, columns, rank);
                std::vector<Rational> of_rows, of_columns;
                for (std::size_t r = 0; r < rows; ++r)
                    of_rows.emplace_back(1 + static_cast<int>(random() % 6));
                for (std::size_t c = 0; c < columns; ++c)
                    of_columns.emplace_back(1 + static_cast<int>(random() % 6));
                const RationalMatrix inverse = pseudo_inverse(b, of_rows, of_columns);
                EXPECT_TRUE(equal(multiply(b, multiply(inverse, b)), b));
                EXPECT_TRUE(equal(multiply(inverse, multiply(b, inverse)), inverse));
                EXPECT_TRUE(is_self_adjoint(multiply(b, inverse), of_rows));
                EXPECT_TRUE(is_self_adjoint(multiply(inverse, b), of_columns));
            }
}

TEST(RationalMatrix, SolvesWhatHasASolution) {
    std::mt19937 random(5);
    for (int n = 0; n < 20; ++n) {
        const RationalMatrix a = random_matrix(random, 4, 5, 3), x = random_matrix(random, 5, 2, 2);
        const RationalMatrix b = multiply(a, x);
        EXPECT_TRUE(equal(multiply(a, solve(a, b)), b));
    }
}

} // namespace
} // namespace resonform
