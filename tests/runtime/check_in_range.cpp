// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that leave the range of their type are noted, others are not; what the processor noted before, and
// whether it is to stop there, is as it was.
#include "runtime/in_range.hpp"
#include "runtime/pack.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <random>

namespace resonform {
namespace {

constexpr int all_notes = FE_OVERFLOW | FE_UNDERFLOW | FE_INVALID | FE_DIVBYZERO;

template <class Number> class EveryNotingReal : public ::testing::Test {
protected:
    template <class Compute> static bool in(double a, double b, const Compute& compute) {
        Number result{};
        const auto call = [&](const Number& x, const Number& y, Number& into) { into = compute(x, y); };
        return in_range<Number>(call, result, Number(a), Number(b));
    }
    // Its square has no place, nor has that of its reciprocal.
    static Number large() { return math::power(Number(2), math::digits<Number> % 53 == 0 ? 900 : 16000); }
    static Number small() { return Number(1) / large(); }
};
using NotingReals = ::testing::Types<double, long double, Float128, Twice<double>>;
TYPED_TEST_SUITE(EveryNotingReal, NotingReals);

TYPED_TEST(EveryNotingReal, StepsInRange) {
    using N = TypeParam;
    EXPECT_TRUE(range_is_noted());
    EXPECT_TRUE(this->in(3, 7, [](const N& a, const N& b) { return a / b + a * b - b; }));
    EXPECT_TRUE(this->in(3, 3, [](const N& a, const N& b) { return a - b; }));
    EXPECT_TRUE(this->in(0, 3, [](const N& a, const N& b) { return a * b / b; }));
    EXPECT_TRUE(this->in(1e-150, 1e140, [](const N& a, const N& b) { return a * b; }));
    EXPECT_TRUE(this->in(2, 1, [](const N& a, const N& b) {
        using math::sqrt;
        return sqrt(a) + math::root(b, 3);
    }));
}

TYPED_TEST(EveryNotingReal, StepsOutOfRange) {
    using N = TypeParam;
    const N large = this->large(), small = this->small();
    EXPECT_FALSE(this->in(1, 1, [&](const N& a, const N& b) { return (a * large) * (b * large); }));
    EXPECT_FALSE(this->in(1, 1, [&](const N& a, const N& b) { return N(1) / ((a * large) * (b * large)); }));
    EXPECT_FALSE(this->in(3, 3, [&](const N& a, const N& b) { return (a * small) * (b * small); }));
    EXPECT_FALSE(this->in(3, 3, [&](const N& a, const N& b) {
        using math::sqrt; // a compiler that fuses products with sums does not fuse these
        return N(1) + sqrt((a * small) * (b * small));
    }));
    EXPECT_FALSE(this->in(3, 3, [&](const N& a, const N& b) { return (a * small) / (b * large); }));
    EXPECT_FALSE(this->in(1, 0, [](const N& a, const N& b) { return a / b; }));
    EXPECT_FALSE(this->in(0, 0, [](const N& a, const N& b) { return a / b; }));
    EXPECT_FALSE(this->in(-1, 0, [](const N& a, const N&) {
        using math::sqrt;
        return sqrt(a);
    }));
}

TEST(InRange, LostDigitsOfASubnormalResult) {
    const auto product = [](double a, double b, double& x) { x = a * b; };
    double x = 0;
    EXPECT_TRUE(in_range<double>(product, x, 0x1p-1060, 0.5)); // exact
    EXPECT_EQ(x, 0x1p-1061);
    EXPECT_FALSE(in_range<double>(product, x, 0x1.123456789abcdp-1020, 0.125));
    EXPECT_FALSE(in_range<double>(product, x, std::numeric_limits<double>::denorm_min(), 0.5));
}

TEST(InRange, TypesThatDoNotTellComputeNothing) {
    struct Other {};
    int calls = 0;
    Other result;
    EXPECT_FALSE(in_range<Other>([&](Other&) { ++calls; }, result));
    EXPECT_EQ(calls, 0);
}

TEST(InRange, NotesAreAsBefore) {
    const auto product = [](double a, double b, double& x) { x = a * b; };
    double x = 0;
    for (const int before : {0, FE_OVERFLOW, FE_UNDERFLOW | FE_INVALID, all_notes}) {
        std::feclearexcept(FE_ALL_EXCEPT);
        std::feraiseexcept(before);
        EXPECT_TRUE(in_range<double>(product, x, 3.0, 5.0));
        EXPECT_FALSE(in_range<double>(product, x, 1e300, 1e300));
        EXPECT_EQ(std::fetestexcept(all_notes), before);
    }
    std::feclearexcept(FE_ALL_EXCEPT);
}

// Programs that have an overflow stop them want it at their own steps only.
TEST(InRange, DoesNotStopAProgramThatStopsAtOverflow) {
    const auto product = [](double a, double b, double& x) { x = a * b; };
    double x = 0;
    std::feclearexcept(FE_ALL_EXCEPT); // or what other tests have had noted stops it
    feenableexcept(FE_OVERFLOW | FE_UNDERFLOW | FE_INVALID | FE_DIVBYZERO);
    const bool in = in_range<double>(product, x, 1e300, 1e300);
    const int stops = fegetexcept() & all_notes;
    fedisableexcept(all_notes);
    EXPECT_FALSE(in);
    EXPECT_EQ(stops, all_notes);
}

// Random products of powers: noted exactly where one of the partial products has no place.
TEST(InRange, AsExponentsSay) {
    std::mt19937_64 random(5);
    std::uniform_int_distribution<int> exponent(-400, 400);
    int inside = 0;
    for (int repeat = 0; repeat < 2000; ++repeat) {
        std::array<int, 6> e{};
        for (int& one : e) one = exponent(random);
        int sum = 0;
        bool fits = true;
        for (const int one : e) {
            sum += one;
            fits = fits && sum >= -1022 && sum + 1 <= 1023; // of a mantissa between 1 and 2^(6/8)
        }
        double x = 0;
        const auto compute = [](const std::array<int, 6>& powers, double& product) {
            product = 1;
            for (const int one : powers) product = product * std::ldexp(1.1, one);
        };
        EXPECT_EQ(in_range<double>(compute, x, e), fits);
        inside += fits ? 1 : 0;
    }
    EXPECT_GT(inside, 500);
    EXPECT_LT(inside, 1900);
}

TEST(InRange, OneOfSeveralSideBySide) {
    using kernel::Pack;
    const auto square = [](const Pack& a, Pack& x) { x = a * a; };
    Pack x, result;
    for (std::size_t j = 0; j < kernel::pack_lanes; ++j) {
        x = Pack(3.0);
        EXPECT_TRUE(in_range<Pack>(square, result, x));
        x.set(j, 1e200);
        EXPECT_FALSE(in_range<Pack>(square, result, x));
        x.set(j, 1e-200);
        EXPECT_FALSE(in_range<Pack>(square, result, x));
    }
}

} // namespace
} // namespace resonform
