// SPDX-License-Identifier: GPL-3.0-or-later
// Small systems whose solutions can be checked by hand.
#pragma once

namespace resonform::testing {

inline const char* const stiffening_spring = R"(
[system]
name = "stiffening_spring"
[variables]
x = { role = "fast" }
tau = { role = "slow" }
[equations]
x = "x'' + (2 + tau^2)*x + (1 + tau)*x^3 = 0"
tau = "tau' = eps"
)";

inline const char* const duffing = R"(
[system]
name = "duffing"
[variables]
x = { role = "fast" }
X = { role = "drift" }
[equations]
x = "x'' + x + x^3 = 0"
X = "X' = eps*x^2 + eps"
)";

inline const char* const conservative = R"(
[system]
name = "conservative"
[variables]
x = { role = "fast" }
[equations]
x = "x'' + x + x^3 = 0"
)";

inline const char* const damped = R"(
[system]
name = "damped"
[variables]
x = { role = "fast" }
[equations]
x = "x'' + 2*eps*x' + x + x^3 = 0"
)";

// The slow rate may vanish and does not divide the damping: quadratures over slow time.
inline const char* const damped_by_a_slow_variable = R"(
[system]
name = "damped_by_a_slow_variable"
[parameters]
c = {}
[variables]
x = { role = "fast" }
tau = { role = "slow" }
[equations]
x = "x'' + 2*eps*tau*x' + x + x^3 = 0"
tau = "tau' = eps*c"
)";

} // namespace resonform::testing
