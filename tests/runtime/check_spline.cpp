// SPDX-License-Identifier: GPL-3.0-or-later
#include "runtime/pack.hpp"
#include "runtime/panels.hpp"
#include "runtime/spline.hpp"
#include "runtime/twice.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace resonform {
namespace {

// 1 + x + x^3 below 1, and 3 + 4 (x - 1) + 5 (x - 1)^3 from there to 2: a jump in the second derivative.
constexpr std::array<double, 3> breakpoints{0, 1, 2};
constexpr std::array<double, 8> coefficients{1, 1, 0, 1, 3, 4, 0, 5};
constexpr Spline two_pieces{breakpoints.data(), coefficients.data(), 2, 3};

TEST(SplineOfData, HasThePieceThatItsArgumentLiesIn) {
    EXPECT_EQ(spline(two_pieces, 0, 0.5), 1.625);
    EXPECT_EQ(spline(two_pieces, 0, 1.0), 3);
    EXPECT_EQ(spline(two_pieces, 1, 1.0), 4);
    EXPECT_EQ(spline(two_pieces, 2, std::nextafter(1.0, 0.0)), 6 * std::nextafter(1.0, 0.0));
    EXPECT_EQ(spline(two_pieces, 2, 1.0), 0);
    EXPECT_EQ(spline(two_pieces, 3, 1.5), 30);
    EXPECT_EQ(spline(two_pieces, 4, 1.5), 0);
}

TEST(SplineOfData, HasNoValueOutsideOfItsRangeButForRounding) {
    EXPECT_EQ(spline(two_pieces, 0, -0x1p-52), 1 - 0x1p-52);
    for (const double x : std::array<double, 5>{-0.001, 2.001, INFINITY, -INFINITY, NAN})
        EXPECT_TRUE(std::isnan(spline(two_pieces, 0, x))) << x;
}

TEST(SplineOfData, HasTheSameBitsInEveryLaneAndScale) {
    for (const double x : {0.0, 0.3, 1.0, 1.7, 2.0, 2.5}) {
        const double one = spline(two_pieces, 1, x), lane = spline(two_pieces, 1, kernel::Pack(x))[0];
        const double scaled = spline(two_pieces, 1, Scaled<double>(x)).value();
        if (std::isnan(one)) {
            EXPECT_TRUE(std::isnan(lane) && std::isnan(scaled));
            continue;
        }
        EXPECT_EQ(lane, one);
        EXPECT_EQ(scaled, one);
    }
}

// Without the edges the integral in doubled precision halves its panels in vain.
TEST(SplineOfData, IsIntegratedExactlyFromPieceToPiece) {
    using Wide = Twice<double>;
    std::array<Wide, 3> edges;
    std::size_t next = 0;
    const Wide start(0.25), after(1.25); // x = 1/4 + T
    add_edges(two_pieces, start, after, edges, next);
    const auto integrand = [](const Wide& T) {
        return std::array{spline(two_pieces, 0, Wide(T + Wide(0.25)))};
    };
    const auto panels = fit_panels<Wide, 1>(in_pieces(integrand, edges), Wide(1.5));
    ASSERT_EQ(panels.status, Status::ok);
    EXPECT_EQ(panels.panels.size(), 2U);
    // int_{1/4}^{1} 1 + x + x^3 dx + int_0^{3/4} 3 + 4 u + 5 u^3 du
    const double exact = 0.75 + 0.46875 + 0.2490234375 + 2.25 + 1.125 + 0.3955078125;
    Wide sum(0);
    for (const Wide& c : panels.panels.back().coefficient[0]) sum = sum + c;
    EXPECT_LT(std::abs((sum - Wide(exact)).high), 1e-30);
}

TEST(SplineOfData, EndsItsIntegralWhereTheDataEnd) {
    std::array<double, 3> edges{};
    std::size_t next = 0;
    add_edges(two_pieces, 2.0, 1.5, edges, next); // x = 2 - T/2
    EXPECT_EQ(edges, (std::array<double, 3>{4, 2, 0}));
    const auto integrand = [](const double& T) { return std::array{spline(two_pieces, 0, 2 - T / 2)}; };
    const auto panels = fit_panels<double, 1>(in_pieces(integrand, edges), 6.0);
    EXPECT_EQ(panels.status, Status::outside_domain);
    EXPECT_NEAR(panels.end, 4, 1e-11);
}

} // namespace
} // namespace resonform
