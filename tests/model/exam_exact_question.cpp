// SPDX-License-Identifier: GPL-3.0-or-later
// What is zero or positive only by the relations of roots and functions, and in the declared domain.
#include "model/exact/question.hpp"
#include "model/files/read_system.hpp"
#include "model/signs/sign_prover.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

// a and tau of any sign, p, q > 0, w < 1, and what else is declared.
System system_with(const std::string& declared) {
    return read_system_text(
        "[system]\nname = \"s\"\n[parameters]\na = {}\nw = {}\np = { positive = true }\nq = { positive = "
        "true }\n"
        "[variables]\nx = { role = \"fast\" }\ntau = { role = \"slow\" }\n"
        "[equations]\nx = \"x'' + x = a*w*p*q*x^2\"\ntau = \"tau' = eps\"\n[domain]\npositive = [\"1 - w\"" +
            (declared.empty() ? "" : ", \"" + declared + "\"") + "]\n",
        "system.toml");
}

GiNaC::ex read(const System& system, const std::string& text) {
    Scope scope = system.constants();
    for (const Variable& v : system.variables) scope.define(v.name, v.jet.front());
    return read_expression(text, scope, SourceText{});
}

TEST(ExactQuestion, ZeroIsSeenByRelations) {
    const System system = system_with("");
    for (const char* zero :
         {"(1 - w)^(3/2) - (1 - w)*sqrt(1 - w)", "(1 - w)^(5/2) - (1 - 2*w + w^2)*sqrt(1 - w)",
          "sqrt(1 - w)*sqrt(2 - 2*w) - sqrt(2)*(1 - w)", "1/(1 + sqrt(1 - w)) - (1 - sqrt(1 - w))/w",
          "sqrt(p)*sqrt(q) - sqrt(p*q)", "sqrt(p/q) - sqrt(p*q)/q", "exp(a)*exp(-a) - 1",
          "sin(2*a) - 2*sin(a)*cos(a)", "cos(3*a) - 4*cos(a)^3 + 3*cos(a)", "sqrt(2)*sqrt(3) - sqrt(6)",
          "sqrt(1 - 2*w + w^2) - 1 + w"})
        EXPECT_EQ(vanishes(read(system, zero), system), Zero::yes) << zero;
}

TEST(ExactQuestion, OnlyZeroIs) {
    const System system = system_with("");
    for (const char* other : {"(1 - w)^(3/2) - (1 - w)", "sqrt(p)*sqrt(q) - sqrt(p)", "exp(a)*exp(-2*a) - 1",
                              "sqrt(2)*sqrt(3) - sqrt(6) + 1/10^30"})
        EXPECT_EQ(vanishes(read(system, other), system), Zero::no) << other;
    EXPECT_EQ(vanishes(read(system, "sqrt(3 + 2*sqrt(2)) - 1 - sqrt(2)"), system), Zero::unknown);
}

// Of one declaration any spelling is proved.
TEST(ExactQuestion, ADeclarationHoldsInEverySpelling) {
    const std::vector<const char*> of_cosine{"1 - tau^2*cos(3*tau)", "1 - tau^2*(4*cos(tau)^3 - 3*cos(tau))",
                                             "3*tau^2*cos(tau) - 4*tau^2*cos(tau)^3 + 1",
                                             "(2 - 2*tau^2*cos(3*tau))/p"};
    const std::vector<const char*> of_hyperbola{"2 - cosh(tau)", "4*exp(tau) - exp(2*tau) - 1",
                                                "4 - exp(tau) - exp(-tau)"};
    const std::vector<const char*> of_thirds{"tau*sin(tau/2) + cos(tau/3)",
                                             "tau*(3*sin(tau/6) - 4*sin(tau/6)^3) + 2*cos(tau/6)^2 - 1"};
    const std::vector<const char*> of_roots{"sqrt(1 - w) - a", "(1 - w)^(3/2) - a*(1 - w)",
                                            "(p*sqrt(1 - w) - p*a)*sqrt(q)"};
    for (const auto& spellings : {of_cosine, of_hyperbola, of_thirds, of_roots})
        for (const char* declared : spellings)
            for (const char* asked : spellings) {
                const System system = system_with(declared);
                EXPECT_TRUE(provably_positive(read(system, asked), system)) << declared << " for " << asked;
                EXPECT_TRUE(provably_nonzero(read(system, asked), system)) << declared << " for " << asked;
            }
    // Where a declared fraction is positive, what it is divided by is not zero.
    const System divided = system_with("1/tau^2 - cos(3*tau)");
    EXPECT_TRUE(provably_positive(read(divided, of_cosine.front()), divided));
}

TEST(ExactQuestion, ADeclarationHoldsForNothingElse) {
    const System system = system_with("1 - tau^2*cos(3*tau)");
    for (const char* other : {"1 - tau^2*cos(2*tau)", "tau^2*cos(3*tau) - 1", "1 - tau^2*cos(tau)",
                              "1 - 2*tau^2*cos(3*tau)", "cos(3*tau)", "a*(1 - tau^2*cos(3*tau))"}) {
        EXPECT_FALSE(provably_positive(read(system, other), system)) << other;
    }
}

} // namespace
} // namespace resonform
