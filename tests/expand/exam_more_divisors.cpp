// SPDX-License-Identifier: GPL-3.0-or-later
// More divisors than a ring holds: what the message offers is what the system can have.
#include "expand/refusal.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace resonform {

namespace {

// 30 divisors x - 1, ..., x - 30 in a symbol of the ring.
std::string refusal_of_divisors(const std::string& toml, const std::string& symbol) {
    const auto field = test::field_from(toml);
    const Polynomial x = field->ring->gen(field->ring->find(symbol).value());
    std::vector<Polynomial> divisors;
    for (int n = 1; n <= 30; ++n) divisors.push_back(x - Polynomial(Rational(n)));
    const Error e = test::error_when([&] { with_divisors(*field, divisors); }, toml);
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    return e.diagnostic().hint;
}

std::string pair_with(const std::string& tables, const std::string& equations) {
    return "[system]\nname = \"s\"\n[parameters]\nw = { positive = true }\n[variables]\nx = { role = "
           "\"fast\" }\n" +
           tables + "[equations]\n" + equations;
}

} // namespace

TEST(MoreDivisors, OfParametersGoToGraphOrNumbers) {
    EXPECT_EQ(refusal_of_divisors(pair_with("", "x = \"x'' + w^2*x = x^2\"\n"), "w"),
              "ask for a lower order, or give parameters numeric values with --set NAME=VALUE, or take "
              "--format json "
              "with --coefficients graph, or with a value for every parameter take numbers: --digits 30");
}

TEST(MoreDivisors, OfASlowVariableDoNotGoToNumbersNorBesideARootToAGraph) {
    const std::string slow = "s = { role = \"slow\" }\n", rate = "s = \"s' = eps\"\n";
    EXPECT_EQ(refusal_of_divisors(pair_with(slow, "x = \"x'' + w^2*x = s*x^2\"\n" + rate), "s"),
              "ask for a lower order, or give parameters numeric values with --set NAME=VALUE, or take "
              "--format json "
              "with --coefficients graph");
    EXPECT_EQ(refusal_of_divisors(pair_with(slow, "x = \"x'' + (w + s^2)*x = x^2\"\n" + rate), "s"),
              "ask for a lower order, or give parameters numeric values with --set NAME=VALUE");
}

TEST(MoreDivisors, InTheStyleHamiltonianStayInTheRing) {
    EXPECT_EQ(
        refusal_of_divisors("[system]\nname = \"s\"\n[parameters]\nw = { positive = true }\n[variables]\n"
                            "x = { role = \"fast\" }\np = { role = \"fast\" }\n[hamiltonian]\n"
                            "energy = \"p^2/2 + w^2*x^2/2 + x^3\"\nmomenta = { x = \"p\" }\n"
                            "[normal_form]\nstyle = \"hamiltonian\"\n",
                            "w"),
        "ask for a lower order, or give parameters numeric values with --set NAME=VALUE");
}

} // namespace resonform
