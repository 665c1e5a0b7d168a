// SPDX-License-Identifier: GPL-3.0-or-later
// The prover of signs: what it must see, and what it must not claim.
#include "model/files/read_system.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/zero_test.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace resonform {
namespace {

class Positivity : public testing::Test {
protected:
    Positivity()
        : system(read_system_text(
              "[system]\nname = \"s\"\n"
              "[parameters]\nr = { positive = true }\nc = { nonzero = true }\nk = {}\nq = {}\n"
              "[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
              "p = { role = \"slow\", positive = true }\n"
              "[equations]\nx = \"x'' = -x\"\ntau = \"tau' = eps\"\np = \"p' = eps\"\n"
              "[domain]\npositive = [\"1 + tau\", \"k - tau\", \"q\", \"3 - q\"]\n",
              "system.toml")) {}

    GiNaC::ex read(const std::string& text) const {
        Scope scope = system.constants();
        for (const Variable& v : system.variables) scope.define(v.name, v.jet.front());
        return read_expression(text, scope, SourceText{});
    }
    bool positive(const std::string& text) const { return provably_positive(read(text), system); }
    bool nonzero(const std::string& text) const { return provably_nonzero(read(text), system); }

    System system;
};

TEST_F(Positivity, Proves) {
    for (const char* text : {"2",
                             "pi",
                             "r",
                             "p",
                             "eps",
                             "tau^2 + r^2",
                             "r/sqrt(tau^2 + r^2)",
                             "2 + tau^2",
                             "2 - sqrt(2)",
                             "sqrt(tau^2 + r) - sqrt(tau^2)",
                             "sqrt(p^2 + r) - p",
                             "sqrt(5) - sqrt(3)",
                             "13 + 12*q - 4*q^2",
                             "tau^2 - 2*tau*k - 2*tau + 2 + 2*k + k^2",
                             "(1 + k^2)*tau^2 + 2*k*tau + 1",
                             "log(2)",
                             "sin(1)",
                             "sin(pi/5)",
                             "tan(1)",
                             "asin(1/3)",
                             "acos(1/3)",
                             "tanh(1)",
                             "-cos(2)",
                             "-cos(2)*r",
                             "log(1/2)*(tau - k)",
                             "1e400*log(2)",
                             "1e-400*sqrt(2)",
                             "sqrt(2)*1e-200 - sqrt(2)*1e-201",
                             "2^(1/3) - 5/4",
                             "exp(pi) - pi - 19",
                             "c^2",
                             "1/c^2",
                             "exp(tau)",
                             "log(2 + tau^2)",
                             "log(1 + exp(r*tau))",
                             "-log(1/(1 + r))",
                             "cosh(x)",
                             "(tau^2 + 1)^(-3/4)",
                             "sqrt(r)*p",
                             "1 + sqrt(tau^2)",
                             "1 + tau",
                             "(1 + tau)^2",
                             "1/(1 + tau)",
                             "sqrt(1 + tau)",
                             "2 + 2*tau",
                             "r + r*tau",
                             "2 + tau",
                             "1 + tau + r",
                             "k - tau",
                             "1 + 2*tau + tau^2",
                             "1 + k",
                             "atan(r)",
                             "q",
                             "q*(3 - q)",
                             "-(1 + tau)*(-1 - tau)",
                             "(tau - k)*(tau - k)*r",
                             "(1 + tau)*(tau^2 + r)",
                             "tau^2 - tau*r + r^2",
                             "r^2 + p^2 - 2*r*p + r*p",
                             "r + p*sin(tau)^2",
                             "r + p - p*cos(tau)^2",
                             "r + p*cos(tau)^2 + p*cos(x)^2 - 2*p*cos(tau)^2*cos(x)^2 - "
                             "2*p*sin(tau)*cos(tau)*sin(x)*cos(x)",
                             "r^2*(c^2 + p) + p^2*(c^2 + p) + 2*r*p*(p - c^2)"}) {
        EXPECT_TRUE(positive(text)) << text;
    }
}

TEST_F(Positivity, DoesNotClaim) {
    for (const char* text : {"tau^2 - 2*tau*r + r^2",
                             "(1 + k^2)*tau^2 + 2*k*tau + 99/100",
                             "0",
                             "-1",
                             "k",
                             "c",
                             "tau",
                             "x",
                             "tau^2",
                             "r - p",
                             "tau - 1",
                             "-r",
                             "sin(tau)",
                             "tau + r",
                             "1/tau^2",
                             "sqrt(tau)",
                             "1 + sqrt(tau)",
                             "exp(sqrt(tau))",
                             "log(r)",
                             "r*tau",
                             "tau - k",
                             "(1 + tau)*(tau - k)",
                             "r*(q - 3)",
                             "1 + tau - tau^2",
                             "tau^2 - 2*tau*r + r^2",
                             "tau^2 - 3*tau*r + r^2",
                             "x^2 + r*tau - 2*x*tau + 1",
                             "r - p*cos(tau)^2",
                             "r + p - 2*p*cos(tau)^2",
                             "r + p*cos(tau)^2 + p*cos(x)^2 - 2*p*cos(tau)^2*cos(x)^2 - "
                             "3*p*sin(tau)*cos(tau)*sin(x)*cos(x)",
                             "-(1 + tau)",
                             "tan(tau)^2 + 1",
                             "cos(2)",
                             "log(1/2)",
                             "sin(1)^2 + cos(1)^2 - 1",
                             "atan(3) + atan(1/3) - pi/2",
                             "log(1 - pi)",
                             "-log(1 - pi)",
                             "r*cos(2)",
                             "1 + 1/tau^2"}) {
        EXPECT_FALSE(positive(text)) << text;
    }
}

TEST_F(Positivity, Nonzero) {
    for (const char* text : {"c", "-r", "c*r", "c^3", "1/c", "-(1 + tau)", "tau - k", "c*(1 + tau)^(1/2)",
                             "cos(2)", "c*tan(1)", "1/log(2)", "exp(1) - 3", "1e-400"}) {
        EXPECT_TRUE(nonzero(text)) << text;
    }
    for (const char* text : {"k", "tau", "c + 1", "c - r", "sin(r)", "0", "exp(2) - exp(1)^2"})
        EXPECT_FALSE(nonzero(text)) << text;
}

TEST_F(Positivity, OfSumsWithRoots) {
    for (const char* text :
         {"sqrt(r^2 + p) - r", "sqrt(c^2 + 1) - c + tau^2*p", "-r + sqrt(r^2 + p)", "3*r - sqrt(8*r^2)",
          "sqrt(r + sqrt(p)) - sqrt(r)", "sqrt(r) + sqrt(p) - sqrt(r + p)", "r + p - sqrt(r^2 + p^2)",
          "sqrt(r^2 + tau^2 + 1) + tau", "(r^2 + p)^(1/4) - sqrt(r)", "1/sqrt(r) - 1/sqrt(r + p)",
          "sqrt((2 + sin(tau))^2) - sin(tau)", "r*sqrt(r^2 + 1) + r*tau*sqrt(tau^2) + r*tau^2"})
        EXPECT_TRUE(positive(text)) << text;
    for (const char* text : {"sqrt(r^2 - 1) - r", "sqrt(c^2 + 1) - 2*c + tau^2*p", "sqrt(r^2 + p) - 2*r",
                             "sqrt(r^2 + k) + r", "sqrt(tau^2) + tau", "sqrt(r) + sqrt(p) - 5/4*sqrt(r + p)",
                             "r + p - 9/8*sqrt(r^2 + p^2)", "sqrt(r^2 + tau) + r", "2*sqrt(tau^2) - tau",
                             "sqrt((2 + sin(tau))^2) - 4*sin(tau)", "r - sqrt(8*r)"}) {
        EXPECT_FALSE(positive(text)) << text;
        EXPECT_FALSE(positive("-(" + std::string(text) + ")")) << text;
    }
    for (const char* text :
         {"c + sqrt(c^2 + 1)", "c - sqrt(4*c^2)", "k - sqrt(k^2 + r)", "r - sqrt(r + 2*r^2)"})
        EXPECT_TRUE(nonzero(text)) << text;
    for (const char* text : {"r - sqrt(r)", "c - sqrt(c^2)", "c + sqrt(c^2)", "2 + k - sqrt(k^2 + r)"})
        EXPECT_FALSE(nonzero(text)) << text;
}

TEST_F(Positivity, OfOneSymbolOrFunction) {
    for (const char* text : {"p^2 - p + 1", "q + 1/q - 1", "9 - q^2", "q^3 - 27*q + 54",
                             "(q + 1)*(q - 4)*(q - 3)*(q - 5)*(-1)^3", "3*sin(tau) + 4*cos(tau) + 6",
                             "4*sin(tau) - cos(tau) + 6", "2 + cos(tau) + sin(tau)*cos(tau)",
                             "2*sin(tau)^2 - 2*sin(tau)*cos(tau) + cos(tau)^2 + 1/10",
                             "exp(2*tau) - exp(tau) + 1", "exp(tau) + exp(-tau) - 1", "1 + tanh(k)^3",
                             "4 - atan(tau)^2", "cosh(k)^2 - cosh(k) + 1/4", "tau^3 + 3*tau^2 + 3*tau + 1"})
        EXPECT_TRUE(positive(text)) << text;
    for (const char* text : {"p^2 - 2*p + 1", "q + 1/q - 3", "8 - q^2", "3*sin(tau) + 4*cos(tau) + 5",
                             "2*sin(tau) - cos(tau)", "1 + cos(tau)", "sin(tau)*cos(tau) + 49/100",
                             "exp(2*tau) - 3*exp(tau) + 1", "exp(tau) + exp(-tau) - 2", "1 + 2*tanh(k)",
                             "2 - atan(tau)^2", "cosh(k) - 1", "tau^3 + 3*tau^2 + 3*tau", "c^3", "p - p^2"})
        EXPECT_FALSE(positive(text)) << text;
    for (const char* text : {"c^3 + c", "cosh(k) - 1/2", "1/c - c^3/(c^2 + c^4 + 1)"})
        EXPECT_TRUE(nonzero(text)) << text;
    for (const char* text : {"c^3 - c", "1 + cos(tau)", "cosh(k) - 1", "p^2 - 3*p + 2"})
        EXPECT_FALSE(nonzero(text)) << text;
}

// What would contradict a declaration is not: tau = 0 where tau^2 - 2 > 0.
TEST(Domain, ExcludesZeros) {
    const System system =
        read_system_text(test::system_text("s", {{"x", "fast", "x'' = -x"}, {"tau", "slow", "tau' = eps"}},
                                           "[parameters]\na = {}\nb = {}\nr = { positive = true }\n[domain]\n"
                                           "positive = [\"tau^2 - 2\", \"a*b - r\", \"3 - tau^2\"]\n"),
                         "system.toml");
    Scope scope = system.constants();
    scope.define("tau", system.variables[1].jet.front());
    const auto nonzero = [&](const char* text) {
        return provably_nonzero(read_expression(text, scope, SourceText{}), system);
    };
    for (const char* text :
         {"tau", "tau^2 - 1", "tau + 1", "2*tau - 5", "tau^3 - 2*tau", "a", "a + b", "a*b", "b*tau"})
        EXPECT_TRUE(nonzero(text)) << text;
    // Names are what follows of them.
    EXPECT_TRUE(system.variables[1].nonzero && !system.variables[1].positive);
    EXPECT_TRUE(system.parameter("a")->nonzero && !system.parameter("a")->positive);
    for (const char* text : {"2*tau - 3", "tau^2 - 5/2", "a - b", "tau - a", "a*b - 2*r", "a - 1"})
        EXPECT_FALSE(nonzero(text)) << text;
}

// A declared quotient is as positive as its numerator, where its denominator is; where that may have either
// sign, as numerator times denominator.
TEST(Domain, HoldsForNumerators) {
    const auto proves = [](const std::string& declared, const char* text) {
        const System system =
            read_system_text("[system]\nname = \"s\"\n"
                             "[parameters]\nK = { positive = true }\nL = {}\nm = { nonzero = true }\n"
                             "[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
                             "[equations]\nx = \"x'' = -x\"\ntau = \"tau' = eps\"\n"
                             "[domain]\npositive = [\"" +
                                 declared + "\"]\n",
                             "system.toml");
        Scope scope = system.constants();
        scope.define("tau", system.variables[1].jet.front());
        return provably_positive(read_expression(text, scope, SourceText{}), system);
    };
    for (const char* declared : {"1 + tau/K", "tau/K + 1", "2 + 2*tau/K", "K + tau", "(K + tau)/K^2",
                                 "1/K + tau/K^2", "1/(K + tau)", "m^2/(K + tau)"})
        for (const char* text :
             {"K + tau", "(K + tau)/K", "1 + tau/K", "3 + 3*tau/K", "1/K + tau/K^2", "K^2 + K*tau",
              "2*K + tau", "1/(1 + tau/K)", "sqrt(1 + tau/K)", "K + tau + exp(tau)"})
            EXPECT_TRUE(proves(declared, text)) << text << " by " << declared;
    EXPECT_TRUE(proves("1 + tau/m^2", "m^2 + tau"));
    EXPECT_TRUE(proves("1 - tau/(1 + K)", "1 + K - tau"));
    for (const char* text : {"m + tau", "L + tau"}) EXPECT_FALSE(proves("1 + tau/K", text)) << text;
    EXPECT_FALSE(proves("1 + tau/K", "K + 2*tau"));
    EXPECT_FALSE(proves("1 + tau/m", "m + tau"));
    EXPECT_TRUE(proves("1 + tau/m", "m^2 + m*tau"));
}

TEST_F(Positivity, ZeroTestHasThreeAnswers) {
    EXPECT_EQ(vanishes(read("tau - k")), Zero::no);
    EXPECT_EQ(vanishes(read("sin(tau) - tau")), Zero::no);
    EXPECT_EQ(vanishes(read("(tau+1)^2 - tau^2 - 2*tau - 1")), Zero::yes);
    EXPECT_EQ(vanishes(read("1/(tau+1) - 1/(tau-1) + 2/(tau^2-1)")), Zero::yes);
    EXPECT_EQ(vanishes(read("sin(tau)^2 + cos(tau)^2 - 1")), Zero::unknown);
    EXPECT_EQ(vanishes(read("1e-30*tau")), Zero::no);
    for (const char* beyond_doubles :
         {"1e400", "1e-400", "1e400*tau", "1e-400*tau*sqrt(tau + k)", "1e154*1e154*k"})
        EXPECT_EQ(vanishes(read(beyond_doubles)), Zero::no) << beyond_doubles;
    EXPECT_EQ(vanishes(read("1e400*tau - 1e200*1e200*tau")), Zero::yes);
    EXPECT_EQ(vanishes(read("atan(3) + atan(1/3) - pi/2")), Zero::unknown);
    EXPECT_EQ(vanishes(read("exp(tau)*exp(k) - exp(tau + k) + 1e-30")), Zero::unknown);
}

TEST_F(Positivity, EnclosuresHoldTheValue) {
    for (const char* text :
         {"sin(2)^2 + cos(2)^2 - 1", "exp(log(3) + 1) - 3*exp(1)", "cosh(2)^2 - sinh(2)^2 - 1",
          "tan(2)*cos(2) - sin(2)", "asin(1/7) + acos(1/7) - pi/2", "(5^(1/3))^6 - 25",
          "tanh(2)*cosh(2) - sinh(2)", "tan(atan(9)) - 9", "log(1e-300) + log(1e300)"}) {
        const auto value = enclose(read(text), {}, 200);
        ASSERT_TRUE(value) << text;
        EXPECT_TRUE(value->contains_zero()) << text;
        EXPECT_LT(2 * mag_get_d(arb_radref(value->get())), 1e-50) << text;
    }
    for (const char* no_value : {"log(cos(2))", "sqrt(1 - pi)", "asin(pi)", "tau",
                                 "1/(atan(3) + atan(1/3) - pi/2)", "exp(1000000)", "exp(-1000000)"})
        EXPECT_FALSE(enclose(read(no_value), {}, 64)) << no_value;
}

TEST_F(Positivity, EnclosuresHoldTheValueAtAPoint) {
    const GiNaC::exmap point{{system.variables[1].jet[0], GiNaC::numeric(1, 3)}};
    for (const char* text :
         {"sin(tau)^2 + cos(tau)^2 - 1", "exp(log(tau) + 1) - tau*exp(1)", "cosh(tau)^2 - sinh(tau)^2 - 1",
          "tan(tau)*cos(tau) - sin(tau)", "asin(tau) + acos(tau) - pi/2", "sqrt(tau)^2 - tau",
          "tanh(tau)*cosh(tau) - sinh(tau)", "tan(atan(tau)) - tau"}) {
        const auto value = enclose(read(text), point, 64);
        ASSERT_TRUE(value) << text;
        EXPECT_TRUE(value->contains_zero()) << text << " " << nearest_double(*value);
        EXPECT_LT(mag_get_d(arb_radref(value->get())), 1e-12) << text;
    }
    EXPECT_FALSE(enclose(read("exp(exp(exp(tau + 10)))"), point, 64));
}

} // namespace
} // namespace resonform
