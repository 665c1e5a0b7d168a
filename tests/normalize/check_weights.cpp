// SPDX-License-Identifier: GPL-3.0-or-later
// Rational weights, and fast variables of different weights: the same results as in integers after a
// substitution, and as with other weights where both hold a monomial.
#include "normalize/certified.hpp"
#include "normalize/hamiltonians.hpp"
#include "normalize/recursion/centre_manifold.hpp"
#include "normalize/recursion/inverse_map.hpp"
#include "normalize/styles/normalize.hpp"
#include "normalize/substituted.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace resonform {
namespace {

using test::expect_same; // weights are held as integers: what differs is how they are read
using test::field_from;

struct FastVariable {
    std::string name, weight;
};

std::string file(const std::vector<FastVariable>& fast, const std::string& equations,
                 const std::string& parameters = "", const std::string& more = "") {
    std::string text = "[system]\nname = \"test\"\n[parameters]\n" + parameters + "[variables]\n";
    for (const FastVariable& f : fast)
        text += f.name + " = { role = \"fast\", weight = \"" + f.weight + "\" }\n";
    return text + more + "[equations]\n" + equations;
}

// x = sqrt(eps) X: with eps = d^2, x is of weight 1 in d.
TEST(Weights, VanDerPolOfTheSizeOfTheRootOfEps) {
    const auto roots =
        field_from(file({{"x", "1/2"}}, "x = \"x'' + x + x^2*sqrt(eps) - (eps - x^2)*x' = eps^(3/2)\"\n"));
    const auto integers =
        field_from(file({{"x", "1"}}, "x = \"x'' + x + x^2*eps - (eps^2 - x^2)*x' = eps^3\"\n"));
    EXPECT_EQ(roots->system().eps_root, 2);
    EXPECT_EQ(roots->system().weight(3), Rational(3) / 2);
    const Normalization n = test::certified(roots, 7);
    EXPECT_EQ(n.certificate.through_weight, Rational(7) / 2);
    expect_same(n, test::certified(integers, 7));
    const Polynomial growth = test::coefficient_of(*roots, n.normal_form.mode[0], {{"z1", 1}, {"eps", 2}});
    EXPECT_EQ(growth, test::coefficient(*roots, "1/2"));
}

// Damping of weight 1/2 against a weak nonlinearity, a slow variable, a declared parameter of weight 3/2.
TEST(Weights, StrongDamping) {
    const std::string slow = "s = { role = \"slow\" }\n";
    const auto roots = field_from(file(
        {{"x", "1"}}, "x = \"x'' + 2*sqrt(d*eps)*x' + (1 + s^2)*x + x^3 = m*x\"\ns = \"s' = eps^(3/2)\"\n",
        "d = { positive = true }\nm = { weight = \"3/2\" }\n", slow));
    const auto integers = field_from(
        file({{"x", "2"}}, "x = \"x'' + 2*sqrt(d)*eps*x' + (1 + s^2)*x + x^3 = m*x\"\ns = \"s' = eps^3\"\n",
             "d = { positive = true }\nm = { weight = 3 }\n", slow));
    expect_same(test::certified(roots, 7), test::certified(integers, 7));
}

// The Poincare normal form and its map are determined as formal series: other weights give other
// truncations of the same.
void expect_common_terms(const std::shared_ptr<const GradedField>& a,
                         const std::shared_ptr<const GradedField>& b, int through, std::size_t fewest) {
    Normalization one = test::certified(a, through * a->system().eps_root),
                  other = test::certified(b, through);
    const Ring &of_one = *one.normal_form.field->ring, &of_other = *other.normal_form.field->ring;
    const auto left = test::all_series(one), right = test::all_series(other);
    ASSERT_EQ(left.size(), right.size());
    std::size_t common = 0;
    for (std::size_t k = 0; k < left.size(); ++k) {
        const Polynomial q = right[k].series->total(through);
        for (const Term& t : left[k].series->total(one.map.through).terms()) {
            std::vector<int> powers = of_one.exponents(t.monomial);
            powers[static_cast<std::size_t>(a->eps)] /= of_one.weights_in_one();
            const Monomial m = of_other.monomial(powers);
            if (of_other.weight(m) > through) continue;
            const auto found = std::find_if(q.terms().begin(), q.terms().end(),
                                            [&](const Term& u) { return u.monomial == m; });
            ASSERT_NE(found, q.terms().end()) << left[k].name;
            EXPECT_EQ(found->coefficient, t.coefficient) << left[k].name;
            ++common;
        }
    }
    EXPECT_GE(common, fewest);
}

TEST(Weights, TwoOscillatorsOfWeightsOneAndTwo) {
    const std::string equations =
        "x = \"x'' + x + y + x*y + eps*x' = eps^2\"\ny = \"y'' + 9/4*y - x^2 + x*y^2 - eps*y' = 0\"\n";
    const auto of = [&](const char* x, const char* y) {
        return field_from(file({{"x", x}, {"y", y}}, "x = \"x'' + x + x*y + x^3 + eps*x' = eps^2\"\n"
                                                     "y = \"y'' + 9/4*y - x^2 + x*y^2 - eps*y' = 0\"\n"));
    };
    expect_common_terms(of("1", "2"), of("1", "1"), 5, 40);
    expect_common_terms(of("2", "3"), of("1", "1"), 6, 40);
    expect_common_terms(of("1", "3/2"), of("1", "1"), 5, 40);
    // y drives x linearly: a term of higher weight, removed by the map.
    const auto coupled = field_from(file({{"x", "1"}, {"y", "2"}}, equations));
    EXPECT_TRUE(coupled->basis.modes[0].column[2].is_zero());
    test::certified(coupled, 5);
}

TEST(Weights, AFiniteVariableBesideASmallOne) {
    test::certified(
        field_from(file({{"u", "0"}, {"x", "1"}},
                        "u = \"u'' + u = eps*(1 - u^2)*u' + x^2\"\nx = \"x'' + 2*x = eps*u^2 + x^2*u\"\n")),
        3);
}

TEST(Weights, TheMapHasAnInverse) {
    const auto field = field_from(file(
        {{"x", "1"}, {"y", "3/2"}, {"u", "0"}},
        "x = \"x'' + x + y + x*y + sqrt(eps)*x' = eps*sin(p)\"\ny = \"y' = -y + x^2 + s*x*sqrt(eps)\"\n"
        "s = \"s' = eps*x + sqrt(eps)*y\"\np = \"p' = 2 + s^2 + eps*u\"\nu = \"u' = -2*u + x + eps*u^2\"\n",
        "", "s = { role = \"slow\" }\np = { role = \"angle\" }\n"));
    const Normalization n = test::certified(field, 5);
    const NearIdentityMap inverse = invert(n.normal_form, n.map);
    const GradedField& used = *n.normal_form.field;
    const auto check = [&](const std::vector<Series>& a, const std::vector<Series>& b) {
        for (std::size_t k = 0; k < a.size(); ++k) {
            const Series composed = compose(used, b[k], inverse, n.map.through);
            for (int w = 0; w <= n.map.through; ++w) EXPECT_TRUE((a[k].part(w) + composed.part(w)).empty());
        }
    };
    check(inverse.mode, n.map.mode);
    check(inverse.slow, n.map.slow);
    check(inverse.angle, n.map.angle);
    test::Substituted(n).expect(inverse);
}

// h of x'' + x + x^3 = 0 begins at weight 3 and has odd weights: each substitution gains two.
TEST(Weights, SubstitutionsTakeOnlyWhatTheyMakeRight) {
    const Normalization n = test::certified(test::duffing(), 8);
    const GradedField& field = *n.normal_form.field;
    std::vector<int> taken;
    for (const SubstitutionStep& step : substitutions(field, n.map, 8, {}))
        taken.push_back(step.mode.front());
    EXPECT_EQ(taken, (std::vector{4, 6, 8}));
    EXPECT_TRUE(substitutions(field, n.map, 8, {false}).empty()) << "there is nothing but the mode";
}

TEST(Weights, TheCatalanSlowManifoldOfTheWeightOfASquare) {
    const auto of = [&](const char* y) {
        return field_from(file({{"x", "1"}, {"y", y}}, "x = \"x' = x*y\"\ny = \"y' = -y + x^2\"\n"));
    };
    expect_common_terms(of("2"), of("1"), 7, 8);
    EXPECT_NO_THROW(centre_manifold(test::certified(of("2"), 7)));
}

TEST(Weights, JordanBlocksOfEachWeight) {
    const auto of = [&](const char* weight, const char* power) {
        return field_from(file({{"x", weight}, {"y", weight}, {"u", "2"}, {"v", "2"}},
                               std::string("x = \"x' = y\"\ny = \"y' = x^2 + ") + power +
                                   "*x + x*u\"\nu = \"u' = v\"\nv = \"v' = x*v + u^2\"\n",
                               "", "[normal_form]\nstyle = \"inner_product\"\n"));
    };
    test::certified(of("1", "eps"), 4);
    test::certified(of("1/2", "sqrt(eps)"), 6);
}

TEST(Weights, OfAnEnergy) {
    const auto of = [&](const std::string& weight, const std::string& small) {
        std::string text = test::one_degree("px^2/2 + x^2/2 + x^4/4 + " + small + "*x^2*px");
        for (const char* name : {"\nx = {", "\npx = {"})
            text.replace(text.find(name) + std::string(name).size(), 0, " weight = \"" + weight + "\",");
        return field_from(text + "[normal_form]\nstyle = \"hamiltonian\"\n");
    };
    const Normalization roots = test::certified(of("1/2", "sqrt(eps)"), 6);
    const Normalization integers = test::certified(of("1", "eps"), 6);
    expect_same(roots, integers);
    for (int n = 0; n <= 7; ++n)
        EXPECT_EQ(roots.normal_form.hamiltonian->energy.part(n),
                  integers.normal_form.hamiltonian->energy.part(n));
}

TEST(Weights, CoefficientsInAGraph) {
    const auto field = field_from(file({{"x", "1"}, {"y", "2"}},
                                       "x = \"x'' + a^2*x + x*y + x^2 + sqrt(eps)*x = 0\"\n"
                                       "y = \"y'' + b^2*y - x^2 + eps*y^2 = 0\"\n",
                                       "a = { positive = true }\nb = { positive = true }\n"));
    EXPECT_TRUE(certify(normalize_in_graph(field, 8)).holds);
}

// The first line of the message, without the name of the file.
std::string refusal(const std::function<void()>& what) {
    try {
        what();
    } catch (const Error& error) {
        const Diagnostic& d = error.diagnostic();
        return std::to_string(static_cast<int>(error.kind())) + " " + d.rule + ": " + d.value;
    }
    return "";
}

TEST(Weights, WhatIsLighterThanTheVariableThatItDrivesIsRefused) {
    const auto of = [&](const std::string& x, const std::string& y) {
        return refusal([&] {
            field_from(file({{"x", "1"}, {"y", "2"}},
                            "x = \"x'' + x = " + x + "\"\ny = \"y'' + 2*y = " + y + "\"\n"));
        });
    };
    EXPECT_EQ(of("0", "x - x^3"),
              "3 a term in the rate of a fast variable has its weight at least: x of weight "
              "1 in the rate of y', which has weight 2");
    EXPECT_EQ(of("0", "sqrt(eps)*x"),
              "3 a term in the rate of a fast variable has its weight at least: eps^(1/2)*x of weight 3/2 in "
              "the rate of y', which has weight 2");
    EXPECT_EQ(of("sqrt(eps)", "0"),
              "3 a term in the rate of a fast variable has its weight at least: eps^(1/2) of weight 1/2 in "
              "the rate of x', which has weight 1");
    EXPECT_EQ(of("y + eps*x", "x^2 + eps*x + eps^2"), "");
}

TEST(Weights, WhatIsAsHeavyAsTheVariableIsNotResonant) {
    const auto of = [&](const std::string& y) {
        return refusal([&] {
            normalize_poincare(field_from(file({{"x", "1"}, {"y", "2"}},
                                               "x = \"x'' + x = 0\"\ny = \"y'' + 4*y = " + y + "\"\n")),
                               2);
        });
    };
    EXPECT_EQ(of("x^2"),
              "3 a term of the weight of the fast variable in whose rate it stands is not resonant "
              "with it: in the normal form of z3 at weight 2");
    EXPECT_EQ(of("x^3 + eps*x"), "");
}

TEST(Weights, AnOrderIsNotBelowThem) {
    const auto field =
        field_from(file({{"x", "1"}, {"y", "5/2"}}, "x = \"x'' + x = y\"\ny = \"y'' + 2*y = 0\"\n"));
    EXPECT_EQ(
        refusal([&] { normalize(field, 4); }),
        "2 the order of a normal form is not below the weight of a fast variable: order 2, y has weight "
        "5/2");
    EXPECT_EQ(refusal([&] { normalize(field, 199); }), "2 the order of a normal form is from 1 to 99: 199/2");
}

TEST(Weights, OfAModeAreOne) {
    EXPECT_EQ(refusal([&] {
                  field_from(file({{"x", "1"}, {"y", "2"}}, "x = \"x' = x\"\ny = \"y' = 2*y\"\n", "",
                                  "[modes]\nz1 = { eigenvalue = \"1\", u = { x = \"1\", y = \"1\" } }\n"
                                  "z2 = { eigenvalue = \"2\", u = { y = \"1\" } }\n"));
              }),
              "2 the fast variables in the column of the mode have different weights: x has weight 1, y has "
              "weight 2");
}

TEST(Weights, OfCanonicalVariablesAreOne) {
    std::string text = test::one_degree("px^2/2 + x^2/2");
    text.replace(text.find("px = {"), 6, "px = { weight = 2,");
    const auto of = [&](const std::string& style) {
        return refusal(
            [&] { normalize(field_from(text + "[normal_form]\nstyle = \"" + style + "\"\n"), 3); });
    };
    EXPECT_EQ(of("poincare"),
              "3 a term in the rate of a fast variable has its weight at least: -x of weight 1 "
              "in the rate of px, which has weight 2");
}

} // namespace
} // namespace resonform
