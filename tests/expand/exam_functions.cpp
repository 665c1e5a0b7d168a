// SPDX-License-Identifier: GPL-3.0-or-later
// One form for one function: identities between exponentials, angles, logarithms hold in the ring.
#include "expand/ring/coefficient_ring.hpp"
#include "model/files/read_system.hpp"
#include "model/text/canonical.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// Left sides and right sides of equations between functions of a, b, tau and x, y > 0, in one ring.
class Identities : public ::testing::TestWithParam<const char*> {};

std::shared_ptr<const System> names() {
    return std::make_shared<const System>(read_system_text(
        "[system]\nname = \"s\"\n[parameters]\na = {}\nb = {}\nx = { positive = true }\ny = { positive = "
        "true }\n"
        "[variables]\npsi = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
        "[functions]\nomega = { of = [\"tau\"], positive = true }\n[domain]\npositive = [\"1 + tau\"]\n"
        "[equations]\npsi = \"psi'' + psi = 0\"\ntau = \"tau' = eps\"\n",
        "system.toml"));
}

GiNaC::ex read(const System& system, const std::string& text) {
    Scope scope = system.constants();
    scope.define("tau", system.variables[1].jet[0]);
    scope.define_function("omega");
    return read_equation(text, scope, SourceText{});
}

TEST_P(Identities, HoldInTheRing) {
    const auto system = names();
    const GiNaC::ex difference = read(*system, GetParam());
    CoefficientRing ring(system);
    ring.collect(difference, {});
    ring.freeze();
    EXPECT_TRUE(ring.ring()->vanishes(ring.convert(difference, {}))) << spell(difference);
    EXPECT_EQ(ring.ring()->is_zero(ring.convert(difference + 1, {})), Zero::no);
}

INSTANTIATE_TEST_SUITE_P(
    All, Identities,
    ::testing::Values(
        "exp(2*tau)*exp(-tau/2) = exp(3*tau/2)", "exp(tau + a) = exp(tau)*exp(a)",
        "sin(2*tau) = 2*sin(tau)*cos(tau)", "cos(3*tau) = 4*cos(tau)^3 - 3*cos(tau)",
        "sin(tau/2)^2 = (1 - cos(tau))/2", "sin(a + b) = sin(a)*cos(b) + cos(a)*sin(b)",
        "cos(a - b)^2 + sin(b - a)^2 = 1", "cosh(tau)^2 - sinh(tau)^2 = 1", "tanh(tau)*cosh(tau) = sinh(tau)",
        "log(x*y^2) = log(x) + 2*log(y)", "log(4*x) = 2*log(2) + log(x)",
        "log(sqrt(x/y)) = (log(x) - log(y))/2", "exp(a*log(x))^2 = exp(2*a*log(x))", "exp(2*log(x)) = x^2",
        "log(exp(tau)*x) = tau + log(x)", "atan(-tau) + atan(tau) = 0", "asinh(-tau) + asinh(tau) = 0",
        "erf(-tau) + erf(tau) = 0", "sin(a*(b + tau)) = sin(a*b + a*tau)",
        "exp(sin(2*tau)) = exp(sin(tau)*cos(tau))^2", "1/(1 + tau) = exp(-log(1 + tau))",
        "sqrt(2 + cos(2*tau))^2 = 1 + 2*cos(tau)^2", "omega(tau)*omega(a)/omega(tau) = omega(a)",
        "exp(tau)/(1 + exp(2*tau)) = 1/(2*cosh(tau))", "sin(1.51968)^2 = 1 - cos(1.51968)^2",
        "cos(3.03936) = 2*cos(1.51968)^2 - 1", "sin(2*atan(tau)) = 2*tau/(1 + tau^2)",
        "cos(acos(1/(1 + x)) + tau)*(1 + x) = cos(tau) - sqrt(x*(x + 2))*sin(tau)",
        "tan(asin(1/(1 + x)))^2*x*(x + 2) = 1", "cos(pi/2 - 3*atan(tau) + a) = sin(3*atan(tau) - a)"));

// What the ring cannot decide it does not claim.
TEST(Functions, DependentOnesAreNotCanonical) {
    const auto system = names();
    const auto canonical = [&](const std::string& text) {
        CoefficientRing ring(system);
        ring.collect(read(*system, text), {});
        ring.freeze();
        return ring.ring()->is_canonical();
    };
    EXPECT_TRUE(canonical("exp(tau)*sin(a) + log(x) + omega(tau) = cos(tau*a)"));
    EXPECT_TRUE(canonical("sqrt(2 + cos(tau)) = sin(tau)"));
    EXPECT_TRUE(canonical("atan(tau) = log(x)"));
    EXPECT_FALSE(canonical("atan(tau) = atan(tau^3)"));
    EXPECT_FALSE(canonical("exp(1/(1 + tau)) = exp(tau/(1 + tau))"));
    EXPECT_FALSE(canonical("log(2) = log(3)"));
    EXPECT_TRUE(canonical("asinh(tau) = log(x)"));
    EXPECT_TRUE(canonical("erf(tau) = exp(-tau^2)"));
    EXPECT_FALSE(canonical("asinh(tau) = atan(tau)"));
    EXPECT_FALSE(canonical("atanh(tanh(tau)/2) = log(x)"));
    EXPECT_TRUE(canonical("cos(2*atan(tau)) = exp(tau)"));  // (1 - tau^2)/(1 + tau^2)
    EXPECT_FALSE(canonical("cos(atan(tau)/2) = exp(tau)")); // a root of roots
    EXPECT_FALSE(canonical("exp(asinh(tau)) = sin(tau)"));  // tau + sqrt(1 + tau^2)
    EXPECT_FALSE(canonical("log(2 + cos(tau)) = log(2 - cos(tau))"));
}

} // namespace
} // namespace resonform
