// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that is shown or refused depends on the order in which symbols were made.
#include "model/text/canonical.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace resonform {

namespace {

using GiNaC::ex;

// What `show` says of an expression in three symbols, made anew several times.
std::set<std::string> over_symbol_orders(const std::function<ex(const ex&, const ex&, const ex&)>& build,
                                         const std::function<std::string(const ex&)>& show) {
    std::set<std::string> seen;
    constexpr int repetitions = 30;
    for (int k = 0; k < repetitions; ++k) {
        const GiNaC::symbol a("a"), b("b"), c("c");
        seen.insert(show(build(a, b, c)));
    }
    return seen;
}

std::string spelled_operands(const ex& e) {
    std::string text;
    for (const ex& operand : operands(e)) text += spell(operand) + "; ";
    return text;
}

} // namespace

TEST(Canonical, OperandsOfSumsAndProducts) {
    const auto sum = [](const ex& a, const ex& b, const ex& c) {
        return GiNaC::acos(a) + GiNaC::asin(b) + a * b - 3 * c;
    };
    EXPECT_EQ(over_symbol_orders(sum, spelled_operands),
              std::set<std::string>{"-3*c; a*b; acos(a); asin(b); "});
    const auto product = [](const ex& a, const ex& b, const ex& c) {
        return 2 * GiNaC::pow(a + b, 2) * c * GiNaC::sin(a);
    };
    EXPECT_EQ(over_symbol_orders(product, spelled_operands),
              std::set<std::string>{"(a + b)^2; 2; c; sin(a); "});
}

TEST(Canonical, SignsOfFactors) {
    const auto fraction = [](const ex& a, const ex& b, const ex& c) {
        return ((a - b) / (c - a) + (b - a) * c / (a + c)).normal();
    };
    EXPECT_EQ(over_symbol_orders(fraction, spell),
              (std::set<std::string>{
                  "(-a*c -a^2 -a^2*c -b*c^2 + a*b + a*b*c + a*c^2 + b*c)*(-c + a)^(-1)*(a + c)^(-1)"}));
    const GiNaC::symbol a("a"), b("b");
    EXPECT_EQ(spell(GiNaC::pow(b - a, 3) * b), "-(-b + a)^3*b");
    EXPECT_EQ(spell(GiNaC::pow(b - a, 2) * b), "(-b + a)^2*b");
    EXPECT_EQ(spell(GiNaC::pow(b - a, -1)), "-(-b + a)^(-1)");
    EXPECT_EQ(spell(canonical_sign(1 - a)), "-1 + a");
}

} // namespace resonform
