// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be solved by quadratures is refused, with the mend.
#include "solve/line.hpp"
#include "solve/systems.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

void expect_error(const std::string& toml, int order, int truncation, Kind kind, const std::string& value,
                  const std::string& mend) {
    const auto normalization = std::make_shared<const Normalization>(
        normalize_poincare(field_of(read_system_text(toml, "test.toml")), truncation));
    try {
        solve(normalization, {order, truncation});
        FAIL() << "accepted";
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), kind);
        EXPECT_EQ(e.diagnostic().value, value);
        EXPECT_EQ(e.diagnostic().mend, mend);
        EXPECT_EQ(e.diagnostic().place.file, "test.toml");
    }
}

TEST(Refusal, ASlowVariableWithoutExplicitLaw) {
    const std::string curved = R"(
[system]
name = "curved"
[variables]
x = { role = "fast" }
tau = { role = "slow" }
[equations]
x = "x'' + (2 + tau^2)*x = 0"
tau = "tau' = eps*tau"
)";
    expect_error(curved, 2, 2, Kind::refused, "the rate depends on eps or on slow variables",
                 "use a variable that grows linearly in time, e.g. the slow time itself");
}

TEST(Refusal, TwoSlowVariables) {
    const std::string two = R"(
[system]
name = "two"
[variables]
x = { role = "fast" }
tau = { role = "slow" }
mu = { role = "slow" }
[equations]
x = "x'' + (2 + tau^2)*x + mu*x^3 = 0"
tau = "tau' = eps"
mu = "mu' = eps"
)";
    expect_error(two, 2, 2, Kind::refused, "2 slow variables",
                 "express one by the other: both grow linearly in time");
}

TEST(Refusal, TwoOscillators) {
    const std::string two = R"(
[system]
name = "two"
[variables]
x = { role = "fast" }
y = { role = "fast" }
[equations]
x = "x'' + x + x^3 = 0"
y = "y'' + 9*y + y^3 = 0"
)";
    expect_error(two, 1, 1, Kind::refused, "2 oscillators",
                 "derive and print the normal form; its slow flow is not solved yet");
}

TEST(Refusal, ATruncationBelowTheOrder) {
    expect_error(duffing, 3, 2, Kind::bad_input, "order = 3, truncation = 2",
                 "raise the truncation, or leave it out");
}

} // namespace
