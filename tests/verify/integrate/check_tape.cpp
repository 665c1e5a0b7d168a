// SPDX-License-Identifier: GPL-3.0-or-later
// Tapes: values against GiNaC's own evaluation, Taylor coefficients against GiNaC's derivatives.
#include "model/files/read_system.hpp"
#include "support/error_when.hpp"
#include "support/exact.hpp"
#include "verify/function_cases.hpp"
#include "verify/integrate/first_order.hpp"
#include "verify/integrate/taylor_jet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

namespace resonform {
namespace {

double number(const GiNaC::ex& e) { return GiNaC::ex_to<GiNaC::numeric>(e.evalf()).to_double(); }

TEST(TapeFunctions, TaylorCoefficientsAreDerivativesOverFactorials) {
    constexpr int order = 8;
    for (const test::FunctionCase& c : test::function_cases()) {
        test::Builder b;
        const GiNaC::symbol u = b.state("u");
        b.state("w");
        const FirstOrderSystem system = b.build({GiNaC::ex(1), c.make(u)}); // u' = 1, w' = f(u)
        const BoundTape<double> tape(Tape::rates(system), {}, 0.0);
        TaylorJet<double> jet(tape, order);
        jet.expand({0.3, 0.0});
        double factorial = 1;
        for (int n = 0; n < order; ++n) {
            if (n > 0) factorial *= n;
            const double expected =
                number(c.make(u).diff(u, static_cast<unsigned>(n)).subs(u == 0.3)) / factorial;
            EXPECT_NEAR(jet.coefficients(1)[n + 1] * (n + 1), expected,
                        2e-12 * std::max(1.0, std::abs(expected)))
                << c.name << ", derivative " << n;
        }
    }
}

template <class Real> class TapeTypes : public testing::Test {};
using RealTypes = testing::Types<double, long double, Float128, DoubleDouble>;
TYPED_TEST_SUITE(TapeTypes, RealTypes);

// sin^2 + cos^2 = 1, exp(log u) = u, ... in every type to its own precision.
TYPED_TEST(TapeTypes, IdentitiesHoldToThePrecisionOfTheType) {
    using Real = TypeParam;
    test::Builder b;
    const GiNaC::symbol u = b.parameter("u");
    const GiNaC::ex e = b.eps();
    const std::vector<GiNaC::ex> zero{pow(sin(u), 2) + pow(cos(u), 2) - 1,
                                      exp(log(u)) - u,
                                      tan(atan(u)) - u,
                                      sin(asin(u / 2)) - u / 2,
                                      cos(acos(u / 2)) - u / 2,
                                      sinh(asinh(u)) - u,
                                      cosh(acosh(1 + u)) - 1 - u,
                                      tanh(atanh(u)) - u,
                                      pow(cosh(u), 2) - pow(sinh(u), 2) - 1,
                                      pow(sqrt(1 + e), 2) - 1 - e,
                                      tanh(u) * cosh(u) - sinh(u)};
    const std::vector<Real> values =
        evaluate_constants<Real>(Tape::constants(b.system(), zero), {Real(7) / Real(10)}, Real(1) / Real(3));
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_LE(std::abs(to_double_value(values[i])), 16 * RealTraits<Real>::roundoff()) << zero[i];
}

TYPED_TEST(TapeTypes, NumbersPassBetweenTypesWithoutLoss) {
    using Real = TypeParam;
    const Real third = Real(1) / Real(3);
    EXPECT_TRUE(convert<Real>(convert<Float128>(third)) == third);
    EXPECT_EQ(to_double_value(third), 1.0 / 3);
}

TEST(Tape, SharesEqualSubexpressionsAndFoldsConstants) {
    const Tape tape = Tape::rates(test::almost_holonomic_pendulum());
    int roots = 0, pairs = 0;
    for (const Tape::Instruction& s : tape.body()) {
        roots += s.op == Tape::Op::sqrt;
        pairs += s.op == Tape::Op::sin_cos;
    }
    EXPECT_EQ(roots, 1);
    EXPECT_EQ(pairs, 1);
    EXPECT_FALSE(tape.prologue().empty()); // eps*v, r^2
}

TEST(Tape, TextDoesNotDependOnTheOrderInWhichGinacSorts) {
    const auto make = [] {
        test::Builder b;
        const GiNaC::symbol x = b.state("x"), y = b.state("y"), z = b.state("z");
        return Tape::rates(b.build({x * y * z + x / y + y / z + z / x, sin(x + y + z) - x * exp(y - z), -x}));
    };
    const std::string first = make().text();
    std::vector<GiNaC::symbol> spacers; // shifts the serial numbers by which GiNaC orders symbols
    for (int i = 0; i < 50; ++i) {
        spacers.emplace_back("spacer");
        EXPECT_EQ(make().text(), first);
    }
}

// (a - b)^3 is -(b - a)^3 for GiNaC where b comes first, and sums change their signs where fractions are
// brought to a common denominator.
TEST(Tape, TextOfASystemIsTheSameInEveryRun) {
    const std::filesystem::path systems = test::source_dir() / "systems";
    std::vector<GiNaC::symbol> spacers;
    for (const char* name :
         {"almost_holonomic_pendulum", "pendulum_mechanism", "michaelis_menten", "watt_governor"}) {
        std::set<std::string> texts;
        for (int i = 0; i < 6; ++i) {
            spacers.emplace_back("spacer");
            const auto system = std::make_shared<const System>(read_system(systems / name / "system.toml"));
            texts.insert(Tape::rates(solve_for_highest(system)).text());
        }
        EXPECT_EQ(texts.size(), 1U) << name;
    }
}

TEST(Tape, PowersAndProductsOfDifferencesKeepTheirSigns) {
    test::Builder b;
    const GiNaC::symbol x = b.parameter("x"), y = b.parameter("y"), z = b.parameter("z");
    const std::vector<GiNaC::ex> values{pow(x - y, 3),
                                        pow(y - x, 3),
                                        pow(x - y, -3),
                                        pow(y - x, -1) * z,
                                        -z * (x - y) * (y - z) * pow(z - x, 3),
                                        -pow(x - y, 2) / (y - z),
                                        (x - y) / 3 - z * (y - x) * GiNaC::numeric(-2, 7),
                                        sin(y - x),
                                        sin(x - y),
                                        pow(z - y, GiNaC::numeric(3, 2)),
                                        -x,
                                        y - x};
    const std::vector<double> found =
        evaluate_constants<double>(Tape::constants(b.system(), values), {0.25, 0.5, 1.25}, 0.1);
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(found[i], number(values[i].subs(GiNaC::lst{x == 0.25, y == 0.5, z == 1.25})), 1e-12)
            << values[i];
}

TEST(Tape, RefusesWhatItCannotIntegrate) {
    test::Builder b;
    const GiNaC::symbol x = b.state("x");
    const FirstOrderSystem system = b.build({GiNaC::tgamma(x)});
    const Error error = test::error_when([&] { Tape::rates(system); });
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(error.diagnostic().value.find("tgamma"), std::string::npos);
    EXPECT_EQ(error.diagnostic().rule, "direct integration knows the elementary functions");
}

} // namespace
} // namespace resonform
