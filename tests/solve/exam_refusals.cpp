// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be solved is refused, with the hint.
#include "model/files/read_system.hpp"
#include "solve/line.hpp"
#include "solve/solve.hpp"
#include "solve/systems.hpp"
#include "support/error_when.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

using namespace resonform;
using namespace resonform::testing;

namespace {

void expect_error(const std::string& toml, int order, int truncation, ErrorKind kind,
                  const std::string& value, const std::string& hint, Reason reason = Reason::by_kind) {
    const auto normalization = std::make_shared<const Normalization>(
        normalize_poincare(field_of(read_system_text(toml, "test.toml")), truncation));
    const Error e = test::error_when([&] { solve(normalization, {order, truncation}); });
    EXPECT_EQ(e.kind(), kind);
    EXPECT_EQ(e.diagnostic().reason, reason);
    EXPECT_EQ(e.diagnostic().value, value);
    EXPECT_EQ(e.diagnostic().hint, hint);
    EXPECT_EQ(e.diagnostic().place.file, "test.toml");
}

TEST(Refusal, ASlowVariableThatRests) {
    const std::string resting =
        test::system_text("resting", {{"x", "fast", "x'' + (2 + tau^2)*x = 0"}, {"tau", "slow", "tau' = 0"}});
    expect_error(resting, 2, 2, ErrorKind::refused, "tau' = 0", "declare tau as a parameter");
}

// Within the threshold the monomial stays, but it turns: nothing would be slow.
TEST(Refusal, AResonanceThatIsOnlyNear) {
    const std::string near = test::system_text(
        "near", {{"x", "fast", "x'' + x + x*y = 0"}, {"y", "fast", "y'' + 4.01*y + x^2 = 0"}},
        "[normal_form]\nnear = 0.01\n");
    expect_error(near, 2, 2, ErrorKind::refused, "the rate of z1 has a term whose divisor is only near zero",
                 "declare the resonance by [relations], with its detuning, instead of [normal_form] near",
                 Reason::resonance);
}

TEST(Refusal, ATruncationBelowTheOrder) {
    expect_error(duffing, 3, 2, ErrorKind::bad_input, "order = 3, truncation = 2",
                 "raise the truncation, or leave it out");
}

} // namespace
