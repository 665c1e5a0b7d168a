// SPDX-License-Identifier: GPL-3.0-or-later
// The table of functions says of each what its enclosure and the library say too.
#include "algebra/number/number.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/function_call.hpp"
#include "model/text/function_slope.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

constexpr std::int64_t bits = 256;

RealBall value(const GiNaC::ex& e) { return enclose(e, {}, bits).value(); }

// Arguments at which f is real and has a slope.
std::vector<GiNaC::ex> arguments(const FunctionRow& row) {
    std::vector<GiNaC::ex> inside;
    for (const char* u : {"-7/2", "-3/4", "-1/5", "1/7", "2/3", "5/4", "9/2"}) {
        const GiNaC::numeric point(u);
        if (value(asked_of(point, row.function)).is_positive()) inside.emplace_back(point);
    }
    return inside;
}

class Rows : public testing::TestWithParam<FunctionRow> {};

// f'(u) lies between the difference quotients to both sides, as far as f'' goes.
TEST_P(Rows, SlopesAreDerivatives) {
    const FunctionRow& row = GetParam();
    ASSERT_GE(arguments(row).size(), 2U);
    if (row.slope.empty()) return;
    const GiNaC::ex h = GiNaC::pow(GiNaC::numeric(1, 2), 80);
    for (const GiNaC::ex& u : arguments(row)) {
        const GiNaC::ex quotient = (call(row.function, u + h) - call(row.function, u - h)) / (2 * h);
        const double error = nearest_double(value(quotient - slope_of(row.function, u)));
        EXPECT_LT(std::abs(error), 1e-40) << row.name << " at " << u;
    }
}

// What GiNaC differentiates, which is the slope of the second route, is the same.
TEST_P(Rows, SlopesAreThoseOfTheLibrary) {
    const FunctionRow& row = GetParam();
    if (row.slope.empty()) return;
    const GiNaC::symbol x("x");
    for (const GiNaC::ex& u : arguments(row)) {
        const GiNaC::ex slope = call(row.function, x).diff(x).subs(x == u);
        EXPECT_TRUE(value(slope).overlaps(value(slope_of(row.function, u)))) << row.name << " at " << u;
    }
}

TEST_P(Rows, ParityBoundsAndSigns) {
    const FunctionRow& row = GetParam();
    for (const GiNaC::ex& u : arguments(row)) {
        const RealBall f = value(call(row.function, u));
        for (const auto& [bound, side] : {std::pair(row.low, 1), std::pair(row.high, -1)}) {
            if (bound.empty()) continue;
            const GiNaC::ex edge = GiNaC::numeric(cln::cl_N(parse_rational(bound)));
            EXPECT_TRUE(value(side * (call(row.function, u) - edge)).is_positive())
                << row.name << " at " << u;
        }
        EXPECT_TRUE(!row.keeps_sign || f.sign() == value(u).sign()) << row.name << " at " << u;
        if (row.parity == Parity::none) continue;
        const RealBall mirrored = value(call(row.function, -u));
        EXPECT_TRUE((row.parity == Parity::even ? mirrored : mirrored.negative()).overlaps(f)) << row.name;
    }
}

// A row is found by its name, and what is called is that function.
TEST_P(Rows, NamesLeadBack) {
    const FunctionRow& row = GetParam();
    EXPECT_EQ(function_called(row.name), row.function);
    if (row.function == Function::arc_cosine) return; // read as pi/2 - asin(u)
    EXPECT_EQ(function_of(call(row.function, GiNaC::symbol("x"))), row.function);
}

INSTANTIATE_TEST_SUITE_P(All, Rows, testing::ValuesIn(function_rows()),
                         [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace resonform
