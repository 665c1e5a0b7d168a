// SPDX-License-Identifier: GPL-3.0-or-later
// The table [functions], and expressions with functions that are known by their names only.
#include "model/signs/sign_prover.hpp"
#include "model/system/system_file.hpp"
#include "model/text/canonical.hpp"
#include "model/text/named_function.hpp"
#include "model/text/zero_test.hpp"

#include "algebra/number/error.hpp"
#include "model/files/read_system.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

std::string file(const std::string& functions, const std::string& equation = "psi'' + omega(tau)^2*psi = 0") {
    return "[system]\nname = \"s\"\n[parameters]\na = {}\n[variables]\npsi = { role = \"fast\" }\n"
           "tau = { role = \"slow\" }\n[functions]\n" +
           functions + "\n[equations]\npsi = \"" + equation + "\"\ntau = \"tau' = eps\"\n";
}

System with_functions(const std::string& functions,
                      const std::string& equation = "psi'' + omega(tau)^2*psi = 0") {
    return read_system_text(file(functions, equation), "system.toml");
}

std::string message(const std::string& functions, const std::string& equation = "psi'' + psi = 0") {
    const Error e = test::error_when([&] { with_functions(functions, equation); }, functions);
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    return e.what();
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(NamedFunctions, AreReadAndDifferentiated) {
    const System system = with_functions("omega = { of = [\"tau\"], positive = true }");
    ASSERT_EQ(system.functions.size(), 1U);
    const GiNaC::ex omega = named_function("omega", 0, system.variables[1].jet[0]);
    const GiNaC::ex residual = system.equations[0].residual;
    EXPECT_TRUE(residual.diff(system.variables[0].jet[0]).is_equal(omega * omega));
    EXPECT_EQ(spell(omega.diff(system.variables[1].jet[0])), "omega'(tau)");
    EXPECT_TRUE(provably_positive(omega, system));
    EXPECT_FALSE(provably_positive(omega.diff(system.variables[1].jet[0]), system));
}

TEST(NamedFunctions, MayBeWrittenWithPrimes) {
    const System system = with_functions("b = { of = [\"a\"] }", "psi'' + psi + b''(2*a)*psi^2 = 0");
    EXPECT_TRUE(has(spell(system.equations[0].residual), "b''(2*a)"));
}

TEST(NamedFunctions, Complaints) {
    EXPECT_TRUE(has(message("omega = {}"), "not declared with the one name"));
    EXPECT_TRUE(has(message("omega = { of = [] }"), "write omega = { of = [\"tau\"] }"));
    EXPECT_TRUE(has(message("omega = { of = [\"tau\", \"a\"] }"), "the one name"));
    EXPECT_TRUE(has(message("omega = { of = [\"tua\"] }"), "did you mean 'tau'?"));
    EXPECT_TRUE(has(message("omega = { of = [\"psi\"] }"), "on neither a slow variable nor a parameter"));
    EXPECT_TRUE(has(message("omega = { of = [\"tau\"], range = 1 }"), "range"));
    EXPECT_TRUE(has(message("a = { of = [\"tau\"] }"), "the name is used twice"));
    EXPECT_TRUE(has(message("sin = { of = [\"tau\"] }"), "reserved"));
    EXPECT_TRUE(has(message("omega = { of = [\"tau\"] }", "psi'' + omega*psi = 0"), "omega(...)"));
}

TEST(NamedFunctions, ZeroTest) {
    const GiNaC::symbol tau("tau");
    const GiNaC::ex omega = named_function("omega", 0, tau), slope = omega.diff(tau);
    EXPECT_EQ(vanishes(omega - omega), Zero::yes);
    EXPECT_EQ(vanishes(omega - slope), Zero::no);
    EXPECT_EQ(vanishes(omega * slope), Zero::no);
    EXPECT_EQ(vanishes(omega - named_function("b", 0, tau)), Zero::no);
    EXPECT_NE(
        vanishes(named_function("omega", 0, tau * (tau + 1)) - named_function("omega", 0, tau * tau + tau)),
        Zero::no);
}

TEST(Bounds, OfFunctions) {
    const System system = with_functions("omega = { of = [\"tau\"], positive = true }");
    const GiNaC::ex tau = system.variables[1].jet[0], a = system.parameters[0].symbol;
    for (const GiNaC::ex& e :
         {GiNaC::ex(2 + cos(tau)), GiNaC::ex(3 - 2 * sin(tau) * cos(a)), GiNaC::ex(2 + tanh(tau) + tau * tau),
          GiNaC::ex(GiNaC::numeric(7, 4) + atan(a)), GiNaC::ex(cosh(tau) + sin(tau) + GiNaC::numeric(1, 2)),
          GiNaC::ex(2 + sin(tau) + named_function("omega", 0, a))})
        EXPECT_TRUE(provably_positive(e, system)) << spell(e);
    for (const GiNaC::ex& e : {GiNaC::ex(1 + cos(tau)), GiNaC::ex(2 + tau * cos(tau)),
                               GiNaC::ex(1 + atan(tau)), GiNaC::ex(2 + tan(tau))})
        EXPECT_FALSE(provably_positive(e, system)) << spell(e);
}

} // namespace
} // namespace resonform
