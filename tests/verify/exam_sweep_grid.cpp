// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a sweep: ends included, each number rounded once, samples by the published generator.
#include "algebra/number/error.hpp"
#include "support/error_when.hpp"
#include "verify/sweep/grid.hpp"
#include "verify/sweep/size.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

std::vector<double> values_of(const std::string& text) { return SweepGrid({text}, {}).values(0); }

std::string rule_broken_by(const std::vector<std::string>& over) {
    const Error error = test::error_when([&] { const SweepGrid grid(over, {}); });
    return error.diagnostic().rule;
}

} // namespace

TEST(SweepGrid, ValuesAreTheDoublesNearestToTheExactOnes) {
    EXPECT_EQ(values_of("eps=0.1:0.5:5"), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5}));
    EXPECT_EQ(values_of("g=log(1e-3:1e3:7)"), (std::vector<double>{1e-3, 1e-2, 1e-1, 1, 10, 100, 1000}));
    EXPECT_EQ(values_of("x=-1/3,2.5e-1"), (std::vector<double>{-1.0 / 3, 0.25}));
    EXPECT_EQ(values_of("x=2:2:1"), std::vector<double>{2});
}

TEST(SweepGrid, TheFirstAxisIsTheSlowest) {
    const SweepGrid grid({"a=1,2", "b=3,4,5"}, {});
    EXPECT_EQ(grid.points(), 6U);
    EXPECT_EQ(grid.shape(), (std::vector<std::uint64_t>{2, 3}));
    EXPECT_EQ(grid.point(0), (std::vector<double>{1, 3}));
    EXPECT_EQ(grid.point(2), (std::vector<double>{1, 5}));
    EXPECT_EQ(grid.point(3), (std::vector<double>{2, 3}));
}

// The first outputs from state 1234567, as its authors' program prints them.
TEST(SweepGrid, SamplesAreDrawnBySplitMix64) {
    const std::vector<std::uint64_t> published = {6457827717110365317U, 3203168211198807973U,
                                                  9817491932198370423U, 4593380528125082431U,
                                                  16408922859458223821U};
    for (std::size_t n = 0; n < published.size(); ++n)
        EXPECT_EQ(drawn_share(1234567, n), static_cast<double>(published[n] >> 11) * 0x1p-53);
}

TEST(SweepGrid, ASampleIsTheBeginningOfALargerOne) {
    const std::vector<std::string> over = {"eps=log(1e-6:1e-2)", "x=-1:3", "k=1,2,4"};
    const SweepGrid small(over, SweepSample{100, 7}), large(over, SweepSample{5000, 7});
    std::size_t below = 0, twos = 0;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const std::vector<double> point = large.point(i);
        if (i < 100) {
            EXPECT_EQ(point, small.point(i));
        }
        EXPECT_TRUE(point[0] >= 1e-6 && point[0] <= 1e-2 && point[1] >= -1 && point[1] <= 3);
        below += point[0] < 1e-4 ? 1 : 0; // the middle of the logarithm
        twos += point[2] == 2 ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(below), 2500, 150); // 4 standard deviations
    EXPECT_NEAR(static_cast<double>(twos), 5000.0 / 3, 135);
    EXPECT_NE(SweepGrid(over, SweepSample{1, 8}).point(0), small.point(0));
}

TEST(SweepGrid, BadAxes) {
    EXPECT_EQ(rule_broken_by({"eps=2:1:5"}), "the ends of a range must be LO <= HI");
    EXPECT_EQ(rule_broken_by({"eps=log(0:1:5)"}), "a logarithmic range must have LO > 0");
    EXPECT_EQ(rule_broken_by({"eps=0:1:0"}), "N of LO:HI:N must be an integer from 1 to 16777216");
    EXPECT_EQ(rule_broken_by({"eps=0:1:1"}),
              "a range with N = 1 must have LO = HI, for both ends are included");
    EXPECT_EQ(rule_broken_by({"a=1", "a=2"}), "each name must be given once");
    for (const char* text : {"eps=1,,2", "eps=nan", "eps=1:x:3", "eps="})
        EXPECT_EQ(rule_broken_by({text}), "a value must be a decimal number or a fraction") << text;
    EXPECT_EQ(rule_broken_by({"eps=1:2"}), "a range must be LO:HI:N");
    for (const char* text : {"eps", "=1", ""})
        EXPECT_EQ(rule_broken_by({text}),
                  "an axis must be NAME=LO:HI:N, NAME=log(LO:HI:N) or NAME=V1,V2,...");
    EXPECT_EQ(rule_broken_by({"a=1:2:1000000", "b=1:2:1000000", "c=1:2:1000000"}),
              "a sweep has at most 2^40 numbers: points x times x outputs");
}

TEST(SweepSize, EveryPointLiesInOneBlock) {
    for (const std::uint64_t points : {1U, 7U, 255U, 1000U, 1'000'000U, 100'000'000U}) {
        const SweepSize size = size_of_sweep(points, 2, 4);
        std::uint64_t total = 0;
        for (std::uint64_t b = 0; b < size.blocks(); ++b) {
            EXPECT_EQ(size.first(b), total);
            total += size.count(b);
        }
        EXPECT_EQ(total, points);
        EXPECT_LE(size.block * 8, 1U << 16);
    }
    EXPECT_LE(size_of_sweep(std::uint64_t(1) << 38, 1, 4).blocks(), (1U << 16) + 1);
}

} // namespace resonform
