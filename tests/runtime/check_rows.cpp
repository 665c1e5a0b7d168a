// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of rows at one point, against cosines and sines of the whole angles.
#include "runtime/kernel/lanes.hpp"
#include "runtime/pack.hpp"
#include "runtime/rows.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace resonform {
namespace {

// Two angles and an exponent; k + 3 in digits: '#' is 0. Harmonics 0, (0, 1, 0), (0, 1, 2), (1, -3, 1),
// (1, 2, 0) and (3, 0, 0), all waves of them, six in the first output, none in the second, five in the third.
constexpr RowList<3, 3, 6, 11, 3> rows({0, 6, 6, 11}, "#&#&#&#&#'#&#&#'#(#'###'#'#(#&#)#&#&",
                                       "###%#&#'#(#)#*#+#,#-#.");

// As RowList says it.
std::array<long double, 3> expected(const std::array<double, 11>& amplitudes, double first, double second,
                                    double exponent) {
    std::array<long double, 3> sums{};
    const auto terms = rows.terms();
    for (std::size_t r = 0; r < terms.size(); ++r) {
        const auto& [output, wave, k] = terms[r];
        const long double angle =
            k[0] * static_cast<long double>(first) + k[1] * static_cast<long double>(second);
        const long double turned = wave == kernel::Wave::sine ? std::sin(angle) : std::cos(angle);
        sums[output] += amplitudes[r] * turned * std::exp(k[2] * static_cast<long double>(exponent));
    }
    return sums;
}

TEST(Rows, TextSaysTheirTerms) {
    const auto terms = rows.terms();
    EXPECT_EQ(terms[0].wave, kernel::Wave::one);
    EXPECT_EQ(terms[1].wave, kernel::Wave::cosine);
    EXPECT_EQ(terms[2].wave, kernel::Wave::sine);
    EXPECT_EQ(terms[5].k, (std::array<int, 3>{1, -3, 1}));
    EXPECT_EQ(terms[5].output, 0U);
    EXPECT_EQ(terms[6].output, 2U);
    EXPECT_EQ(terms[10].k, (std::array<int, 3>{3, 0, 0}));
    EXPECT_EQ(terms[10].wave, kernel::Wave::sine);
}

TEST(Rows, SumsAreThoseOfWholeAngles) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> any(-3, 3);
    for (int sample = 0; sample < 100; ++sample) {
        std::array<double, 11> amplitudes{};
        for (double& a : amplitudes) a = any(random);
        const double first = any(random), second = any(random), exponent = -std::abs(any(random));
        const std::array<Turn<double>, 3> turns{{{std::cos(first), std::sin(first)},
                                                 {std::cos(second), std::sin(second)},
                                                 {std::exp(exponent), 0}}};
        const auto sums = sum_rows(rows, amplitudes, turns);
        const auto exact = expected(amplitudes, first, second, exponent);
        for (std::size_t k = 0; k < sums.size(); ++k)
            EXPECT_NEAR(sums[k], static_cast<double>(exact[k]), 2e-14) << k;

        std::array<kernel::Pack, 11> packed;
        std::array<Turn<kernel::Pack>, 3> packed_turns;
        for (std::size_t r = 0; r < packed.size(); ++r) packed[r] = kernel::Pack(amplitudes[r]);
        for (std::size_t p = 0; p < turns.size(); ++p)
            packed_turns[p] = {kernel::Pack(turns[p].cosine), kernel::Pack(turns[p].sine)};
        const auto side_by_side = sum_rows(rows, packed, packed_turns);
        for (std::size_t k = 0; k < sums.size(); ++k) EXPECT_NEAR(side_by_side[k][0], sums[k], 1e-14) << k;
    }
}

} // namespace
} // namespace resonform
