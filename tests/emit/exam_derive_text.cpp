// SPDX-License-Identifier: GPL-3.0-or-later
// The documents of the pendulum as they are printed: (16), (19), (20) to (23) of the paper.
#include "printed.hpp"
#include "solve/solve.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

// The paper's plain truncation, normal form and map through weight 3.
Solution as_published(std::shared_ptr<const Normalization> normalization) {
    SolveOptions options;
    options.order = 3;
    options.truncation = 3;
    return solve(std::move(normalization), options);
}

TEST(DeriveText, NormalForm) {
    const auto normalization = pendulum(3);
    const Solution solution = as_published(normalization);
    const std::string document = print_normal_form(*normalization, 3, Format::text, &solution);
    EXPECT_EQ(document.substr(0, document.find("\nnear-identity map:")),
              R"(normal form of almost_holonomic_pendulum through weight 3 (style poincare)

z1' = I*sqrt(g)/(r^2 + xi^2)^(1/4)*z1
      - xi/(4*(r^2 + xi^2))*z1*xi'
      - I*xi^2/(32*sqrt(g)*(r^2 + xi^2)^(7/4))*z1*xi'^2 - I*sqrt(g)/(16*(r^2 + xi^2)^(1/4))*z1^2*z2
z2' = -I*sqrt(g)/(r^2 + xi^2)^(1/4)*z2
      - xi/(4*(r^2 + xi^2))*z2*xi'
      + I*xi^2/(32*sqrt(g)*(r^2 + xi^2)^(7/4))*z2*xi'^2 + I*sqrt(g)/(16*(r^2 + xi^2)^(1/4))*z1*z2^2
z_X' = -r*xi^2/(g*(r^2 + xi^2)^2)*xi'^3 - r/(4*sqrt(r^2 + xi^2))*z1*z2*xi'
z_Y' = r^2*xi/(g*(r^2 + xi^2)^2)*xi'^3 - xi/(4*sqrt(r^2 + xi^2))*z1*z2*xi'
xi' = eps*v

where:
  z1 = psi - I*psi'/omega + O(eps^2)
  z2 = conj(z1)
  omega = sqrt(g)/(r^2 + xi^2)^(1/4)
  z_X = X + O(eps^2)
  X = x - r*log((xi + sqrt(r^2 + xi^2))/r)
  z_Y = Y + O(eps^2)
  Y = y - sqrt(r^2 + xi^2)
)");
    test::expect_part(document, R"(
  psi - I*psi'/omega = z1
                       + r*xi/(g*(r^2 + xi^2)^(3/2))*xi'^2 + I*xi/(8*sqrt(g)*(r^2 + xi^2)^(3/4))*z2*xi'
)");
    test::expect_part(document, "\ncertificate: holds through weight 3 (substitution, modular; ");
}

TEST(DeriveLatex, NormalForm) {
    const auto normalization = pendulum(3);
    const Solution solution = as_published(normalization);
    const std::string document = print_normal_form(*normalization, 3, Format::latex, &solution);
    EXPECT_EQ(document.substr(0, document.find("near-identity map:")),
              R"(% normal form of almost_holonomic_pendulum through weight 3 (style poincare)
% needs \usepackage{amsmath}
\begin{align*}
  \dot{z}_{1} &= \frac{i \sqrt{g}}{\left(r^{2} + \xi^{2}\right)^{1/4}} z_{1} - \frac{\xi}{4 \left(r^{2} + \xi^{2}\right)} z_{1} \dot{\xi} - \frac{i \xi^{2}}{32 \sqrt{g} \left(r^{2} + \xi^{2}\right)^{7/4}} z_{1} \dot{\xi}^{2} - \frac{i \sqrt{g}}{16 \left(r^{2} + \xi^{2}\right)^{1/4}} z_{1}^{2} z_{2} \\
  \dot{z}_{2} &= -\frac{i \sqrt{g}}{\left(r^{2} + \xi^{2}\right)^{1/4}} z_{2} - \frac{\xi}{4 \left(r^{2} + \xi^{2}\right)} z_{2} \dot{\xi} + \frac{i \xi^{2}}{32 \sqrt{g} \left(r^{2} + \xi^{2}\right)^{7/4}} z_{2} \dot{\xi}^{2} + \frac{i \sqrt{g}}{16 \left(r^{2} + \xi^{2}\right)^{1/4}} z_{1} z_{2}^{2} \\
  \dot{z}_{X} &= -\frac{r \xi^{2}}{g \left(r^{2} + \xi^{2}\right)^{2}} \dot{\xi}^{3} - \frac{r}{4 \sqrt{r^{2} + \xi^{2}}} z_{1} z_{2} \dot{\xi} \\
  \dot{z}_{Y} &= \frac{r^{2} \xi}{g \left(r^{2} + \xi^{2}\right)^{2}} \dot{\xi}^{3} - \frac{\xi}{4 \sqrt{r^{2} + \xi^{2}}} z_{1} z_{2} \dot{\xi} \\
  \dot{\xi} &= \varepsilon v
\end{align*}
where:
\begin{align*}
  z_{1} &= \psi - \frac{i \dot{\psi}}{\omega} + O\left(\varepsilon^{2}\right) \\
  z_{2} &= \overline{z_{1}} \\
  \omega &= \frac{\sqrt{g}}{\left(r^{2} + \xi^{2}\right)^{1/4}} \\
  z_{X} &= X + O\left(\varepsilon^{2}\right) \\
  X &= x - r \ln \left(\frac{\xi + \sqrt{r^{2} + \xi^{2}}}{r}\right) \\
  z_{Y} &= Y + O\left(\varepsilon^{2}\right) \\
  Y &= y - \sqrt{r^{2} + \xi^{2}}
\end{align*}
)");
}

TEST(DeriveText, WithoutASolutionTheDriftStays) {
    const std::string document = print_normal_form(*pendulum(3), 3, Format::text);
    test::expect_part(document, "\nz_x' = r/sqrt(r^2 + xi^2)*xi'\n");
    test::expect_part(document, "\n  z_x = x + O(eps^2)\n");
    EXPECT_EQ(document.find('X'), std::string::npos) << document;
}

TEST(DeriveText, Expansion) {
    const auto normalization = pendulum(3);
    const Solution solution = as_published(normalization);
    EXPECT_EQ(print_expansion(*normalization->normal_form.field, 3, Format::text, &solution),
              R"(equations of almost_holonomic_pendulum, expanded through weight 3

(r^2 + xi^2)*psi'' + g*sqrt(r^2 + xi^2)*psi
- r*xi/(r^2 + xi^2)*xi'^2 + xi*psi'*xi'
- g*sqrt(r^2 + xi^2)/6*psi^3
+ O(eps^5) = 0
xi' = eps*v
x' = r/sqrt(r^2 + xi^2)*xi'
     - xi/sqrt(r^2 + xi^2)*psi*xi'
     - r/(2*sqrt(r^2 + xi^2))*psi^2*xi'
     + O(eps^4)
y' = xi/sqrt(r^2 + xi^2)*xi'
     + r/sqrt(r^2 + xi^2)*psi*xi'
     - xi/(2*sqrt(r^2 + xi^2))*psi^2*xi'
     + O(eps^4)

without the known drift:
  (r^2 + xi^2)*psi'' + g*sqrt(r^2 + xi^2)*psi
  - r*xi/(r^2 + xi^2)*xi'^2 + xi*psi'*xi'
  - g*sqrt(r^2 + xi^2)/6*psi^3
  + O(eps^5) = 0
  xi' = eps*v
  X' = -xi/sqrt(r^2 + xi^2)*psi*xi' - r/(2*sqrt(r^2 + xi^2))*psi^2*xi' + O(eps^4)
  Y' = r/sqrt(r^2 + xi^2)*psi*xi' - xi/(2*sqrt(r^2 + xi^2))*psi^2*xi' + O(eps^4)
  X = x - r*log((xi + sqrt(r^2 + xi^2))/r)
  Y = y - sqrt(r^2 + xi^2)
)");
}

TEST(DeriveLatex, ExpansionWithoutTheKnownDrift) {
    const auto normalization = pendulum(3);
    const Solution solution = as_published(normalization);
    test::expect_part(print_expansion(*normalization->normal_form.field, 3, Format::latex, &solution),
                      R"(without the known drift:
\begin{align*}
  &\left(r^{2} + \xi^{2}\right) \ddot{\psi} + g \sqrt{r^{2} + \xi^{2}} \psi \\
  &\quad - \frac{r \xi}{r^{2} + \xi^{2}} \dot{\xi}^{2} + \xi \dot{\psi} \dot{\xi} \\
  &\quad - \frac{g \sqrt{r^{2} + \xi^{2}}}{6} \psi^{3} + O\left(\varepsilon^{5}\right) = 0 \\
  \dot{\xi} &= \varepsilon v \\
  \dot{X} &= -\frac{\xi}{\sqrt{r^{2} + \xi^{2}}} \psi \dot{\xi} - \frac{r}{2 \sqrt{r^{2} + \xi^{2}}} \psi^{2} \dot{\xi} + O\left(\varepsilon^{4}\right) \\
  \dot{Y} &= \frac{r}{\sqrt{r^{2} + \xi^{2}}} \psi \dot{\xi} - \frac{\xi}{2 \sqrt{r^{2} + \xi^{2}}} \psi^{2} \dot{\xi} + O\left(\varepsilon^{4}\right) \\
  X &= x - r \ln \left(\frac{\xi + \sqrt{r^{2} + \xi^{2}}}{r}\right) \\
  Y &= y - \sqrt{r^{2} + \xi^{2}}
\end{align*}
)");
}

TEST(DeriveText, Solution) {
    const Solution solution = as_published(pendulum(3));
    const std::string document = print_solution(solution, Format::text);
    test::expect_part(document, "\nxi = xi_0 + eps*v*t\n");
    test::expect_part(document, "\n  Delta' = -xi/(4*(r^2 + xi^2))*Delta*xi'\n");
    test::expect_part(document, "\n  Delta = eps*C_delta/(r^2 + xi^2)^(1/8)\n");
    test::expect_part(document, R"(
  theta = theta_0
          + integral(sqrt(g)/(r^2 + xi^2)^(1/4) - eps^2*v^2*xi^2/(32*sqrt(g)*(r^2 + xi^2)^(7/4)) - )"
                                R"(eps^2*sqrt(g)*C_delta^2/(16*sqrt(r^2 + xi^2)), t = 0..t)
)");
    test::expect_part(document, "\n  z_Y = C_Y - eps^2*r^2*v^2/(2*g*(r^2 + xi^2)) - "
                                "eps^2*C_delta^2*(r^2 + xi^2)^(1/4)/2\n");
    test::expect_part(document, "\n  f_y = eps^2*r*v*C_delta/(sqrt(g)*(r^2 + xi^2)^(3/8))*sin(theta)\n");
}

TEST(DeriveLatex, Solution) {
    const std::string document = print_solution(as_published(pendulum(3)), Format::latex);
    test::expect_part(document, R"(
  z_{X} &= C_{X} - \varepsilon^{2} r \int\limits_{\xi_{0}}^{\xi} \left(\frac{v^{2} \xi^{2}}{g )"
                                R"(\left(r^{2} + \xi^{2}\right)^{2}} + \frac{C_{\delta}^{2}}{4 )"
                                R"(\left(r^{2} + \xi^{2}\right)^{3/4}}\right) \, d\xi \\
)");
    test::expect_part(document, R"(\cos \theta)");
}

std::shared_ptr<const Normalization> normalized(const std::string& tables, int order) {
    return std::make_shared<const Normalization>(
        normalize_poincare(field_from("[system]\nname = \"s\"\n[variables]\n" + tables), order));
}

// Each has a name of its own, and T is said where it stands.
TEST(DeriveText, KnownDriftsOfNamesAlike) {
    const auto normalization = normalized(
        "x = { role = \"fast\" }\nq = { role = \"drift\" }\nQ = { role = \"drift\" }\n[equations]\n"
        "x = \"x'' + x + x^3 = 0\"\nq = \"q' = eps*(1 + x)\"\nQ = \"Q' = 2*eps\"\n",
        3);
    const Solution solution = as_published(normalization);
    for (const std::string& text :
         {print_normal_form(*normalization, 3, Format::text, &solution),
          print_expansion(*normalization->normal_form.field, 3, Format::text, &solution)}) {
        test::expect_part(text, "\n  q_new = q - T\n");
        test::expect_part(text, "\n  Q_new = Q - 2*T\n");
        test::expect_part(text, "\nT = eps*t\n");
    }
    test::expect_part(print_normal_form(*normalization, 3, Format::latex, &solution), "T &= \\varepsilon t");
}

// Modes that are no oscillators, a driven slow variable, an angle, finite fast variables.
TEST(DeriveText, OfEveryRole) {
    const auto node = normalized("x = { role = \"fast\" }\ny = { role = \"fast\" }\n[equations]\n"
                                 "x = \"x' = x\"\ny = \"y' = 2*y + x + x^2\"\n",
                                 2);
    const std::string modes = print_normal_form(*node, 2, Format::text, nullptr);
    test::expect_part(
        modes, "z1' = z1\nz2' = 2*z2 + z1^2\n\nwhere:\n  z1 = x + O(eps^3)\n  z2 = x + y + O(eps^3)\n");
    EXPECT_EQ(modes.find("conj"), std::string::npos);

    const auto rotation = normalized("J = { role = \"slow\", positive = true }\nphi = { role = \"angle\" }\n"
                                     "[equations]\nJ = \"J' = eps*cos(phi)\"\nphi = \"phi' = J\"\n",
                                     1);
    test::expect_part(print_normal_form(*rotation, 1, Format::text, nullptr),
                      "phi' = J\nJ' = 0\n\nnear-identity map:\n"
                      "  old(phi) = phi - 1/(2*J^2)*eps*exp(-I*phi) - 1/(2*J^2)*eps*exp(I*phi)\n"
                      "  old(J) = J + I/(2*J)*eps*exp(-I*phi) - I/(2*J)*eps*exp(I*phi)\n");
    test::expect_part(print_normal_form(*rotation, 1, Format::latex, nullptr), "{J}_{\\mathrm{old}} &= J");
    test::expect_part(print_expansion(*rotation->normal_form.field, 1, Format::text),
                      "J' = 1/2*eps*exp(-I*phi) + 1/2*eps*exp(I*phi)\nphi' = J\n");

    const auto finite = normalized("x = { role = \"fast\", weight = 0 }\n[equations]\n"
                                   "x = \"x'' + x = eps*(1 - x^2)*x'\"\n",
                                   1);
    test::expect_part(print_normal_form(*finite, 1, Format::text, nullptr), "z1 = x - I*x'/omega + O(eps)\n");
    test::expect_part(print_expansion(*finite->normal_form.field, 1, Format::text),
                      "x'' + x - x'*eps + x^2*x'*eps = 0\n");
}

// Braces, \left and \right, and environments close.
TEST(DeriveLatex, IsBalanced) {
    const auto normalization = pendulum(4);
    const Solution solution = as_published(normalization);
    const GradedField& field = *normalization->normal_form.field;
    for (const std::string& document :
         {print_equations(field.system(), Format::latex), print_expansion(field, 5, Format::latex, &solution),
          print_normal_form(*normalization, 4, Format::latex, &solution),
          print_solution(solution, Format::latex)}) {
        const auto count = [&](const std::string& word) {
            int n = 0;
            for (std::size_t at = document.find(word); at != std::string::npos;
                 at = document.find(word, at + 1))
                ++n;
            return n;
        };
        EXPECT_EQ(count("{"), count("}"));
        EXPECT_EQ(count("\\left("), count("\\right)"));
        EXPECT_EQ(count("\\begin{align*}"), count("\\end{align*}"));
        EXPECT_GT(count("&"), 0);
        EXPECT_EQ(count("**"), 0);
    }
}

} // namespace
} // namespace resonform::test
