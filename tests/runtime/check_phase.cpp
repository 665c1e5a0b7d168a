// SPDX-License-Identifier: GPL-3.0-or-later
// Phases of many turns against 100 digits: theta = 1 + (1/eps) T/(1 + T), T = eps t.
#include "runtime/phase.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace resonform {

namespace {

using Hundred = boost::multiprecision::cpp_bin_float_100;

template <class Real> Phase<Real> phase_of(const Real& eps) {
    using Wide = typename Phase<Real>::Wide;
    Phase<Real> phase;
    Real end(1);
    const Status status = phase.build(
        [&](const Wide& T) {
            const Wide w = T + Wide(1);
            return std::array<Wide, 1>{Wide(1) / (w * w) / Wide(eps)};
        },
        Wide(1), eps, end);
    EXPECT_EQ(status, Status::ok);
    return phase;
}

// The worst error of cosine and sine over the interval.
template <class Real> double worst_error(const Real& eps) {
    const Phase<Real> phase = phase_of(eps);
    Hundred worst(0);
    for (int i = 0; i < 300; ++i) {
        const Real t = (Real(i) + Real(0.37)) / Real(301) / eps;
        Real cosine(0), sine(0);
        EXPECT_EQ(phase(t, cosine, sine), Status::ok);
        const Hundred T = Hundred(t) * Hundred(eps), theta = 1 + T / (1 + T) / Hundred(eps);
        worst = std::max(
            {worst, Hundred(abs(Hundred(cosine) - cos(theta))), Hundred(abs(Hundred(sine) - sin(theta)))});
    }
    return static_cast<double>(worst);
}

} // namespace

TEST(Phase, CostsNoDigitsUpTo1e14Radians) {
    for (const double eps : {0.1, 1e-3, 1e-6, 1e-10, 1e-14}) EXPECT_LT(worst_error(eps), 2.5e-16) << eps;
}

TEST(Phase, LongDoubleToo) {
    for (const long double eps : {0.1L, 1e-8L})
        EXPECT_LT(worst_error(eps), 1.2e-19) << static_cast<double>(eps);
}

// theta(1/eps) = 1 + 1/(2 eps): the digits of double-double would reach further, the promise does not.
TEST(Phase, BeyondTenToThe14ItSaysSo) {
    double cosine = 0, sine = 0;
    EXPECT_EQ(phase_of(1e-14)(1e14, cosine, sine), Status::ok);
    for (const double eps : {4e-15, 1e-15, 1e-20, 1e-25}) {
        EXPECT_EQ(phase_of(eps)(1 / eps, cosine, sine), Status::low_precision) << eps;
        EXPECT_NEAR(cosine * cosine + sine * sine, 1, 1e-6) << "the numbers are set";
    }
}

// Beyond that not even 10^-3 radians are known, and the phase ends, soon where it is fast.
TEST(Phase, EndsWhereItIsNotKnown) {
    using Wide = Phase<double>::Wide;
    const auto end_of = [](double rate, double end) {
        Phase<double> phase;
        const auto status =
            phase.build([&](const Wide& T) { return std::array<Wide, 1>{Wide(rate) * (Wide(1) + T)}; },
                        Wide(1), 1e-3, end);
        EXPECT_EQ(status, Status::outside_interval) << rate;
        if (end > 0) {
            double cosine = 0, sine = 0;
            EXPECT_EQ(phase(end / 1e-3, cosine, sine), Status::low_precision) << rate;
            EXPECT_NEAR(cosine * cosine + sine * sine, 1, 1e-5) << rate;
        }
        return end;
    };
    const double end = end_of(1, 1e20); // T^2/2 is known to 5e-32 of it
    EXPECT_GT(end, 1e12);
    EXPECT_LT(end, 1e15);
    EXPECT_GT(end_of(1e100, 1), 1e-80);
    EXPECT_LT(end_of(1e100, 1), 1e-70);
    EXPECT_GT(end_of(1, 1e100), 1e8);
}

// A rate known to double's precision only: theta is good to 10^-9 up to some 10^6 radians.
TEST(Phase, OfARoundedRateLosesDigitsEarlier) {
    const auto status = [](double eps) {
        using Wide = Phase<double>::Wide;
        Phase<double> phase;
        const auto rate = [&](const Wide&) { return std::array<Wide, 1>{Wide(1) / Wide(eps)}; };
        double end = 1;
        EXPECT_EQ(phase.build(rate, Wide(0), eps, end, true), Status::ok);
        double cosine = 0, sine = 0;
        return phase(0.999 / eps, cosine, sine);
    };
    EXPECT_EQ(status(1e-6), Status::ok);
    EXPECT_EQ(status(1e-7), Status::low_precision);
}

// A rounded rate: a fast phase is small at small times, though the row of the table in which they stand ends
// at many turns.
TEST(Phase, IsPreciseWhereItIsStillSmall) {
    using Wide = Phase<double>::Wide;
    const double eps = 0.01, rate = 1e7;
    Phase<double> phase;
    double end = 1;
    ASSERT_EQ(phase.build([&](const Wide&) { return std::array<Wide, 1>{Wide(rate / eps)}; }, Wide(0), eps,
                          end, true),
              Status::ok);
    EXPECT_FALSE(phase.precise());
    double cosine = 0, sine = 0;
    for (const double theta : {0.0, 0.01, 3.0, 1e3}) {
        EXPECT_EQ(phase(theta / rate, cosine, sine), Status::ok) << theta;
        EXPECT_NEAR(sine, std::sin(theta), 4e-16 * (1 + theta)) << theta;
    }
    EXPECT_EQ(phase(0.999 / eps, cosine, sine), Status::low_precision);
}

// Beyond 10^14 radians in a row its terms are known to 10^-15 or worse, at its small times, too.
TEST(Phase, IsNowherePreciseWhereItsRowIsNot) {
    using Wide = Phase<double>::Wide;
    Phase<double> phase;
    double end = 1;
    ASSERT_EQ(phase.build([](const Wide&) { return std::array<Wide, 1>{Wide(1e17)}; }, Wide(0), 1.0, end),
              Status::ok);
    double cosine = 0, sine = 0;
    for (const double t : {0.0, 1e-25, 1e-12}) EXPECT_EQ(phase(t, cosine, sine), Status::low_precision) << t;
}

// theta = (T + d log(1 + T/a))/eps, the rate rounded to double: as good as its places, small times too,
// whatever part of a turn a row of the table takes and however slowly the coefficients of the rate decay.
TEST(Phase, OfARoundedRateIsKnownToItsPlacesFromTheStart) {
    using Wide = Phase<double>::Wide;
    const double eps = 1.0 / 1024;
    const auto worst = [&](double a, double d, double end) { // in places of theta + 1
        Phase<double> phase;
        const auto rate = [&](const Wide& T) {
            return std::array<Wide, 1>{Wide((1 + d / (static_cast<double>(T) + a)) / eps)};
        };
        EXPECT_EQ(phase.build(rate, Wide(0), eps, end, true), Status::ok);
        Hundred most(0);
        for (const double t : {0.0, 1e-6, 1e-3, 0.1, 1.0, 10.0, 100.0, 0.999 * end / eps}) {
            double cosine = 0, sine = 0;
            EXPECT_EQ(phase(t, cosine, sine), Status::ok);
            const Hundred T = Hundred(t) * Hundred(eps), theta = (T + d * log(1 + T / a)) / eps;
            const Hundred error = abs(Hundred(cosine) - cos(theta)) + abs(Hundred(sine) - sin(theta));
            most = std::max(most, Hundred(error / (1 + theta)));
        }
        return static_cast<double>(most) / 2.2e-16;
    };
    for (const double end : {0.51, 0.71, 0.99, 1.01, 1.4, 1.99})
        for (const double a : {1.1, 1.3, 1.6, 2.1}) EXPECT_LT(worst(a, 1, end), 4) << a << ' ' << end;
    for (const double d : {1e-6, 3e-7, 1e-7, 3e-8, 1e-8})
        for (const double a : {0.12, 0.16, 0.2}) EXPECT_LT(worst(a, d, 1), 4) << a << ' ' << d;
}

} // namespace resonform
