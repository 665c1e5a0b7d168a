// SPDX-License-Identifier: GPL-3.0-or-later
// Small systems whose solutions can be checked by hand.
#pragma once

#include "support/system_text.hpp"

#include <string>

namespace resonform::testing {

inline const std::string stiffening_spring =
    test::system_text("stiffening_spring", {{"x", "fast", "x'' + (2 + tau^2)*x + (1 + tau)*x^3 = 0"},
                                            {"tau", "slow", "tau' = eps"}});

inline const std::string relaxing_spring = test::system_text(
    "relaxing_spring", {{"x", "fast", "x'' + (2 + s^2)*x + x^3 = 0"}, {"s", "slow", "s' = eps*(1 - 2*s)"}});

inline const std::string duffing =
    test::system_text("duffing", {{"x", "fast", "x'' + x + x^3 = 0"}, {"X", "drift", "X' = eps*x^2 + eps"}});

inline const std::string conservative =
    test::system_text("conservative", {{"x", "fast", "x'' + x + x^3 = 0"}});

inline const std::string damped =
    test::system_text("damped", {{"x", "fast", "x'' + 2*eps*x' + x + x^3 = 0"}});

// The slow rate may vanish and does not divide the damping: quadratures over slow time.
inline const std::string damped_by_a_slow_variable =
    test::system_text("damped_by_a_slow_variable",
                      {{"x", "fast", "x'' + 2*eps*tau*x' + x + x^3 = 0"}, {"tau", "slow", "tau' = eps*c"}},
                      "[parameters]\nc = {}\n");

} // namespace resonform::testing
