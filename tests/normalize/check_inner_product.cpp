// SPDX-License-Identifier: GPL-3.0-or-later
// Normal forms of linear parts that are not semisimple: known invariants, the certificate and its liars,
// random systems; and where the linear part is semisimple, Poincare's normal form.
#include "normalize/lies.hpp"
#include "normalize/recursion/inverse_map.hpp"
#include "normalize/styles/normalize.hpp"
#include "support/error_when.hpp"

#include <random>

namespace resonform {
namespace {

using test::certificate_of;
using test::coefficient;
using test::coefficient_of;

std::string inner_product_file(const std::string& declarations, const std::string& equations,
                               const std::string& style = "inner_product") {
    return "[system]\nname = \"test\"\n" + declarations + "[equations]\n" + equations +
           "[normal_form]\nstyle = \"" + style + "\"\n";
}

constexpr const char* two_variables = "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n";

Normalization certified(const std::string& toml, int through) {
    const Normalization n = normalize(test::field_from(toml), through);
    const Certificate c = certificate_of(n);
    EXPECT_TRUE(c.holds) << c.complaint << "\n" << toml;
    EXPECT_EQ(n.normal_form.style, Style::inner_product);
    return n;
}

using NamedPowers = std::vector<std::pair<std::string, int>>;

// Every term of a rate of weight >= 2 is among those listed.
void expect_terms(const Normalization& n, const Series& rate,
                  const std::vector<std::pair<NamedPowers, std::string>>& expected) {
    const GradedField& field = *n.normal_form.field;
    Polynomial rest = rate.total(n.normal_form.through) - rate.part(0) - rate.part(1);
    for (const auto& [powers, text] : expected)
        rest = rest - field.ring->multiply(test::monomial(*field.ring, powers), coefficient(field, text));
    EXPECT_TRUE(rest.empty()) << rest.size() << " terms left";
}

// x' = y + a20 x^2 + ..., y' = b20 x^2 + b11 x y + ...: on the kernel of the adjoint the form of degree 2 is
// w1' = w2 + beta w1^2, w2' = beta w1 w2 + alpha w1^2, and Bogdanov's and Takens' invariants, the
// coefficients of w1^2 and w1 w2 in w2' with w1' = w2, are alpha = b20 and 3 beta = b11 + 2 a20.
TEST(InnerProduct, BogdanovTakensOfDegreeTwo) {
    const Normalization n = certified(
        inner_product_file(
            "[parameters]\na20 = {}\na11 = {}\na02 = {}\nb20 = {}\nb11 = {}\nb02 = {}\n" +
                std::string(two_variables),
            "x = \"x' = y + a20*x^2 + a11*x*y + a02*y^2\"\ny = \"y' = b20*x^2 + b11*x*y + b02*y^2\"\n"),
        2);
    expect_terms(n, n.normal_form.mode[0], {{{{"z1", 2}}, "(2*a20 + b11)/3"}});
    expect_terms(n, n.normal_form.mode[1],
                 {{{{"z1", 1}, {"z2", 1}}, "(2*a20 + b11)/3"}, {{{"z1", 2}}, "b20"}});
}

TEST(InnerProduct, BogdanovTakensOfAnyDegreeHasTwoTermsInEach) {
    const Normalization n = certified(
        inner_product_file(two_variables,
                           "x = \"x' = 2*y + x^2 - x*y^2\"\ny = \"y' = 3*x^2 + x*y - y^2 + x^3 + x^2*y\"\n"),
        7);
    const GradedField& field = *n.normal_form.field;
    for (int degree = 2; degree <= 7; ++degree) {
        const NamedPowers first{{"z1", degree}}, second{{"z1", degree - 1}, {"z2", 1}};
        EXPECT_LE(n.normal_form.mode[0].part(degree).size(), 1U);
        EXPECT_LE(n.normal_form.mode[1].part(degree).size(), 2U);
        EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], first),
                  coefficient_of(field, n.normal_form.mode[1], second));
    }
}

// x'' = eps^2 mu1 + eps mu2 x' + x^2 + x x': parameters of the unfolding, of the weights of Kuznetsov's.
TEST(InnerProduct, UnfoldingByParameters) {
    const Normalization n = certified(
        inner_product_file("[parameters]\nmu1 = {}\nmu2 = {}\n[variables]\nx = { role = \"fast\" }\n",
                           "x = \"x'' = eps^2*mu1 + eps*mu2*x' + x^2 + x*x'\"\n"),
        4);
    const GradedField& field = *n.normal_form.field;
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[1], {{"eps", 2}}), coefficient(field, "mu1"));
    // the trace of the linear part, shared by both
    for (int k : {0, 1})
        EXPECT_EQ(coefficient_of(field, n.normal_form.mode[static_cast<std::size_t>(k)],
                                 {{"eps", 1}, {k == 0 ? "z1" : "z2", 1}}),
                  coefficient(field, "mu2/2"));
}

// Parameters as variables: m' = 0 drives y, a third mode of the eigenvalue zero. The inner product treats it
// as the others.
TEST(InnerProduct, UnfoldingByVariables) {
    const Normalization n = certified(
        inner_product_file(
            "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\nm = { role = \"fast\" }\n",
            "x = \"x' = y\"\ny = \"y' = 2*m + m*y + x^2 + x*y\"\nm = \"m' = 0\"\n"),
        4);
    ASSERT_EQ(n.normal_form.field->couplings(1).size(), 1U);
    EXPECT_EQ(n.normal_form.field->couplings(1)[0].mode, 2U);
    EXPECT_EQ(n.normal_form.field->couplings(1)[0].factor, 1);
}

// 1:1 resonance of two oscillators, not semisimple (Elphick et al. 1987; Iooss and Adelmeyer): with A = z1, B
// = z3, u = A conj A, v = A conj B - B conj A,
//   A' = i w A + B + A P(u, v),   B' = i w B + B P(u, v) + A Q(u, v)
TEST(InnerProduct, ResonanceOfTwoEqualOscillators) {
    const Normalization n =
        certified(inner_product_file("[parameters]\nw = { positive = true }\n" + std::string(two_variables),
                                     "x = \"x'' + w^2*x = y + 2*x^3 - x*y*y'\"\ny = \"y'' + w^2*y = "
                                     "3*x^2*y - y^3 + x'^3 + 5*x*x'*y\"\n"),
                  3);
    const GradedField& field = *n.normal_form.field;
    const auto c = [&](std::size_t mode, const NamedPowers& powers) {
        return coefficient_of(field, n.normal_form.mode[mode], powers);
    };
    const NamedPowers a2b{{"z1", 2}, {"z4", 1}}, abc{{"z1", 1}, {"z2", 1}, {"z3", 1}},
        a2{{"z1", 2}, {"z2", 1}};
    for (const auto& term : field.ring->collect(n.normal_form.mode[0].part(3), field.outer()))
        EXPECT_GE(field.ring->exponent(term.first, field.modes[0].z), 1); // A P
    EXPECT_EQ(c(0, abc), -c(0, a2b));
    EXPECT_EQ(c(1, {{"z1", 1}, {"z3", 1}, {"z4", 1}}), c(0, a2b));
    EXPECT_EQ(c(1, {{"z2", 1}, {"z3", 2}}), -c(0, a2b));
    EXPECT_EQ(c(1, abc), c(0, a2) - c(1, a2b));
    EXPECT_TRUE(c(1, {{"z3", 2}, {"z4", 1}}).empty());
    EXPECT_FALSE(c(0, a2b).empty() || c(0, a2).empty() || c(1, a2).empty() || c(1, a2b).empty());
}

// Graded by eps alone: x' = y, y' = eps (x^2 y - x^3) with finite x and y.
TEST(InnerProduct, FiniteVariables) {
    const Normalization n = certified(
        inner_product_file(
            "[variables]\nx = { role = \"fast\", weight = 0 }\ny = { role = \"fast\", weight = 0 }\n",
            "x = \"x' = y + eps*x^2\"\ny = \"y' = eps*(x^2*y - x^3)\"\n"),
        3);
    const GradedField& field = *n.normal_form.field;
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[1], {{"z1", 3}, {"eps", 1}}),
              coefficient(field, "-1"));
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[0], {{"z1", 2}, {"eps", 1}}),
              coefficient(field, "2/3"));
}

// A kept small divisor beside a chain; what is zero exactly is not kept for being small.
TEST(InnerProduct, NearDivisors) {
    const std::string text =
        inner_product_file("[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\nu = { role = "
                           "\"fast\" }\n",
                           "x = \"x' = y + x*u\"\ny = \"y' = x^2 + x*y\"\nu = \"u' = 1/10*u + x^2\"\n");
    const Normalization n = certified(text + "near = 0.2\n", 3);
    const GradedField& field = *n.normal_form.field;
    EXPECT_FALSE(coefficient_of(field, n.normal_form.mode[2], {{"z1", 2}}).empty());
    EXPECT_EQ(coefficient_of(field, n.normal_form.mode[1], {{"z1", 2}}), coefficient(field, "1"));
    const Normalization all = certified(text, 3);
    EXPECT_TRUE(coefficient_of(*all.normal_form.field, all.normal_form.mode[2], {{"z1", 2}}).empty());
}

struct StyleCase {
    std::string name, declarations, equations;
    int through, couplings;
};
std::ostream& operator<<(std::ostream& out, const StyleCase& c) { return out << c.name; }

const std::vector<StyleCase> styles_compared = {
    {"double_real", "", "x = \"x' = x + y + x*y\"\ny = \"y' = -x - y + x^2\"\n", 4, 1},
    {"critical_damping", "[parameters]\nd = { positive = true }\n",
     "x = \"x'' + 2*d*x' + d^2*x + x^2 = 0\"\n", 3, 1},
    {"saddle_chain", "", "x = \"x' = x + y\"\ny = \"y' = y + x*y^2 + y^2\"\n", 4, 1},
    {"two_equal_oscillators", "[parameters]\nw = { positive = true }\nc = { nonzero = true }\n",
     "x = \"x'' + w^2*x = c*y + x^2\"\ny = \"y'' + w^2*y + x*y^2 + y*x^2 = 0\"\n", 3, 1},
    {"double_frequency", "", "x = \"x'' + 2*x + y + x^3 = 0\"\ny = \"y'' - x + y^3 = 0\"\n", 3, 1},
    {"critical_damping_of_a_driven_one", "", "x = \"x' = -x + y\"\ny = \"y'' + 2*y' + y = x*y + eps*x^2\"\n",
     3, 2},
    {"oscillator_beside_a_chain", "", "x = \"x' = y' + x*y\"\ny = \"y'' + 2*y = x^2 + x*y\"\n", 3, 0},
    {"reversed", "", "x = \"x' = x*y + y^2\"\ny = \"y' = x - y^2\"\n", 4, 1},
};

TEST(InnerProduct, SystemsOfEveryKind) {
    for (const StyleCase& c : styles_compared) {
        const bool both = c.equations.find("y = ") != std::string::npos;
        const std::string variables = both ? two_variables : "[variables]\nx = { role = \"fast\" }\n";
        const Normalization n =
            certified(inner_product_file(c.declarations + variables, c.equations), c.through);
        int couplings = 0;
        for (std::size_t k = 0; k < n.normal_form.field->modes.size(); ++k)
            couplings += static_cast<int>(n.normal_form.field->couplings(k).size());
        EXPECT_EQ(couplings, c.couplings) << c;
    }
}

// Slow variables, driven and not, an angle and a drift about a chain whose coupling depends on a slow
// variable.
constexpr const char* every_role = "[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\ns = { "
                                   "role = \"slow\", positive = true }\n"
                                   "p = { role = \"angle\" }\nX = { role = \"drift\" }\n";
constexpr const char* equations_of_every_role =
    "x = \"x' = s*y + eps*x + x^2\"\ny = \"y' = x^2 + x*y*s + eps^2*cos(p)\"\ns = \"s' = x*y + eps*y\"\n"
    "p = \"p' = 1 + s + x*y\"\nX = \"X' = y^2 + eps*x\"\n";

TEST(InnerProduct, EveryRole) {
    const Normalization n = certified(inner_product_file(every_role, equations_of_every_role), 4);
    const GradedField& field = *n.normal_form.field;
    for (const auto* list : {&n.normal_form.slow, &n.normal_form.angle, &n.normal_form.drift, &n.map.slow,
                             &n.map.angle, &n.map.drift})
        for (const Series& s : *list)
            for (int k = 0; k <= s.through(); ++k) EXPECT_EQ(field.ring->conjugate(s.part(k)), s.part(k));
    const NearIdentityMap inverse = invert(n.normal_form, n.map);
    for (std::size_t k = 0; k < inverse.mode.size(); ++k) {
        const Series composed = compose(field, n.map.mode[k], inverse, 4);
        for (int w = 0; w <= 4; ++w)
            EXPECT_TRUE(field.ring->vanishes(inverse.mode[k].part(w) + composed.part(w)));
    }
}

TEST(InnerProductLies, AreFound) {
    EXPECT_GT(test::expect_all_lies_found(
                  normalize(test::field_from(inner_product_file(
                                two_variables, "x = \"x' = y + x*y\"\ny = \"y' = x^2 + 2*x*y - y^2\"\n")),
                            3)),
              26);
    EXPECT_GT(test::expect_all_lies_found(
                  normalize(test::field_from(inner_product_file(every_role, equations_of_every_role)), 2)),
              40);
}

// Through the top weight h - c and N + L c obey the equations whatever c is; only one of them is the normal
// form.
TEST(InnerProductLies, AnotherComplementIsFound) {
    const Normalization truth = normalize(
        test::field_from(inner_product_file(two_variables, "x = \"x' = y\"\ny = \"y' = x^2 + x*y\"\n")), 3);
    const Ring& ring = *truth.normal_form.field->ring;
    const auto term = [&](const NamedPowers& powers) { return test::monomial(ring, powers); };
    const auto add = [](Series& s, const Polynomial& p) { s.set(3, s.part(3) + p); };
    { // c = (z1^2 z2, 0): L c = (2 z1 z2^2, 0)
        Normalization n = truth;
        add(n.map.mode[0], -term({{"z1", 2}, {"z2", 1}}));
        add(n.normal_form.mode[0], Rational(2) * term({{"z1", 1}, {"z2", 2}}));
        const Certificate c = certificate_of(n);
        EXPECT_TRUE(c.residual_zero) << c.complaint;
        EXPECT_FALSE(c.normal_form_scan);
        EXPECT_EQ(c.complaint, "normal form of the modes, weight 3: not in the kernel of the adjoint");
    }
    { // c = (z1 z2^2, z2^3): L c = 0
        Normalization n = truth;
        add(n.map.mode[0], term({{"z1", 1}, {"z2", 2}}));
        add(n.map.mode[1], term({{"z2", 3}}));
        const Certificate c = certificate_of(n);
        EXPECT_TRUE(c.residual_zero) << c.complaint;
        EXPECT_FALSE(c.normal_form_scan);
        EXPECT_EQ(c.complaint, "map of the modes, weight 3: not orthogonal to the kernel");
    }
}

TEST(InnerProductLies, TheFieldItselfIsNoNormalForm) {
    const auto field =
        test::field_from(inner_product_file(two_variables, "x = \"x' = y + x*y\"\ny = \"y' = x^2\"\n"));
    Normalization n = normalize(field, 3);
    const FieldSeries given = evaluate_field(*field, 3);
    for (std::size_t k = 0; k < 2; ++k) {
        n.map.mode[k] = Series();
        n.normal_form.mode[k] = given.mode[k];
        n.normal_form.mode[k].set(1, field->linear_part(k));
    }
    const Certificate c = certificate_of(n);
    EXPECT_TRUE(c.residual_zero) << c.complaint;
    EXPECT_FALSE(c.normal_form_scan);
}

TEST(InnerProductLies, ACouplingLeftOutIsFound) {
    Normalization n = normalize(
        test::field_from(inner_product_file(two_variables, "x = \"x' = y\"\ny = \"y' = x^2\"\n")), 2);
    const GradedField& field = *n.normal_form.field;
    n.normal_form.mode[0].set(1, Polynomial());
    EXPECT_NE(certificate_of(n).complaint.find("with its couplings"), std::string::npos);
    EXPECT_EQ(field.couplings(0).size(), 1U);
}

// Where nothing is nilpotent the styles agree to the last term.
TEST(InnerProduct, OfASemisimpleLinearPartIsPoincares) {
    for (const auto& [variables, equations] : std::vector<std::pair<std::string, std::string>>{
             {"[variables]\nx = { role = \"fast\" }\n", "x = \"x'' + x + x^2 + x*x'^2 = 0\"\n"},
             {two_variables, "x = \"x' = x\"\ny = \"y' = 2*y + x + x^2 + x*y\"\n"},
             {two_variables, "x = \"x'' + x = x^2 + y\"\ny = \"y'' + 4*y = x*y\"\n"}}) {
        Normalization a = normalize(test::field_from(inner_product_file(variables, equations)), 4);
        Normalization b =
            normalize(test::field_from(inner_product_file(variables, equations, "poincare")), 4);
        const auto one = test::all_series(a), other = test::all_series(b);
        for (std::size_t k = 0; k < one.size(); ++k)
            for (int w = 0; w <= 4; ++w)
                EXPECT_EQ(one[k].series->part(w), other[k].series->part(w)) << one[k].name << "\n"
                                                                            << equations;
        EXPECT_TRUE(certificate_of(a).holds);
    }
}

std::string refusal(const std::string& toml) {
    const Error e = test::error_when([&] { static_cast<void>(normalize(test::field_from(toml), 2)); });
    EXPECT_EQ(e.kind(), ErrorKind::refused);
    return e.diagnostic().rule + " | " + e.diagnostic().hint;
}

TEST(InnerProduct, Refusals) {
    EXPECT_NE(refusal(inner_product_file(two_variables, "x = \"x' = y\"\ny = \"y' = x^2\"\n", "poincare"))
                  .find("write style = \"inner_product\" in [normal_form]"),
              std::string::npos);
    EXPECT_NE(
        refusal(inner_product_file(two_variables, "x = \"x' = y + x\"\ny = \"y' = -x - y\"\n", "poincare"))
            .find("write style = \"inner_product\" in [normal_form]"),
        std::string::npos);
    // z drives x by two ways
    EXPECT_NE(refusal(inner_product_file("[parameters]\na = { nonzero = true }\n" +
                                             std::string(two_variables) + "z = { role = \"fast\" }\n",
                                         "x = \"x' = y + a*z\"\ny = \"y' = z\"\nz = \"z' = x^2\"\n"))
                  .find("couplings of modes that have one eigenvalue can be scaled to numbers"),
              std::string::npos);
    EXPECT_NE(refusal(inner_product_file(two_variables, "x = \"x' = y\"\ny = \"y' = eps + x^2\"\n"))
                  .find("a forcing as large"),
              std::string::npos);
}

// Linear parts of one or two eigenvalues with couplings at random.
std::string random_system(unsigned seed) {
    std::mt19937 random(seed);
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    static const std::vector<std::string> numbers = {"1", "-2", "1/2", "3", "-1/3"};
    const auto number = [&] { return "(" + numbers[static_cast<std::size_t>(pick(5))] + ")"; };
    const int count = 2 + pick(2);
    const bool oscillators = count == 2 && pick(2) == 0, slow = pick(2) == 0;
    std::vector<std::string> names, states;
    for (int k = 0; k < count; ++k) names.push_back("x" + std::to_string(k));
    states = names;
    if (slow) states.emplace_back("s");
    const std::string eigenvalue = pick(2) == 0 ? "0" : "-1";
    std::string variables = "[variables]\n", equations;
    for (int k = 0; k < count; ++k) {
        variables += names[static_cast<std::size_t>(k)] + " = { role = \"fast\" }\n";
        std::string right = oscillators ? "-2*" : eigenvalue + "*";
        right += names[static_cast<std::size_t>(k)];
        if (k > 0) right += " + " + number() + "*" + names[static_cast<std::size_t>(pick(k))];
        for (int t = 0; t < 2; ++t)
            right += " + " + number() + "*" + states[static_cast<std::size_t>(pick(count))] + "*" +
                     states[static_cast<std::size_t>(pick(static_cast<int>(states.size())))] + "*" +
                     states[static_cast<std::size_t>(pick(count))];
        right += " + eps*" + number() + "*" + names[static_cast<std::size_t>(pick(count))];
        equations += names[static_cast<std::size_t>(k)] + " = \"" + names[static_cast<std::size_t>(k)] +
                     (oscillators ? "''" : "'") + " = " + right + "\"\n";
    }
    if (slow) {
        variables += "s = { role = \"slow\", positive = true }\n";
        equations += "s = \"s' = eps*" + number() + (pick(2) == 0 ? "*x0" : "") + "\"\n";
    }
    return inner_product_file(variables, equations);
}

TEST(InnerProduct, RandomSystemsAreCertified) {
    int nilpotent = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const std::string toml = random_system(seed);
        const Normalization n = certified(toml, 3);
        if (!n.normal_form.field->is_semisimple()) ++nilpotent;
        const NearIdentityMap inverse = invert(n.normal_form, n.map);
        for (std::size_t k = 0; k < inverse.mode.size(); ++k) {
            const Series composed = compose(*n.normal_form.field, n.map.mode[k], inverse, 3);
            for (int w = 0; w <= 3; ++w)
                EXPECT_TRUE(n.normal_form.field->ring->vanishes(inverse.mode[k].part(w) + composed.part(w)))
                    << toml;
        }
    }
    EXPECT_EQ(nilpotent, 20);
}

} // namespace
} // namespace resonform
