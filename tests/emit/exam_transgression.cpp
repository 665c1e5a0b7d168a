// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of what is constant at eps = 0: the catenary's parametric form, the particle's uniform rise,
// averaged rates, and a drift that oscillates as much as it moves.
#include "printed.hpp"
#include "solve/solve.hpp"
#include "support/error_when.hpp"
#include "support/shell.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

Solution solved(std::shared_ptr<const Normalization> normalization, int order) {
    const int through = normalization->normal_form.through;
    return solve(std::move(normalization), {order, through});
}

std::string transgression_text(const std::string& system, int order) {
    return print_transgression(solved(certified(field_named(system), order + 1), order), Format::text);
}

TEST(Transgression, OfThePendulumIsTheCatenary) {
    EXPECT_EQ(
        transgression_text("almost_holonomic_pendulum", 3),
        R"(transgression of almost_holonomic_pendulum on the time 1/eps (normal form and map through weight 4)

xi = xi_0 + eps*v*t
x = C_X + r*log((xi + sqrt(r^2 + xi^2))/r) + O(eps^2)
y = C_Y + sqrt(r^2 + xi^2) + O(eps^2)

path, to leading order:
  y - C_Y = r*cosh((x - C_X)/r)

xi does not oscillate through order 3
x oscillates about its law: O(eps^2)
y oscillates about its law: O(eps^2)
)");
}

// x and y in turn, with an offset, sinh, and a straight line.
TEST(Transgression, PathsOfOtherKinds) {
    const auto path = [](const std::string& rates) {
        const auto field =
            field_from("[system]\nname = \"s\"\n[parameters]\nr = { positive = true }\nb = {}\n"
                       "[variables]\nxi = { role = \"slow\" }\nx = { role = \"drift\" }\n"
                       "y = { role = \"drift\" }\n[equations]\nxi = \"xi' = eps\"\n" +
                       rates);
        const std::string text = print_transgression(solved(certified(field, 2), 1), Format::text);
        const std::size_t at = text.find("path, to leading order:\n  ");
        return at == std::string::npos ? "none" : text.substr(at + 26, text.find('\n', at + 26) - at - 26);
    };
    EXPECT_EQ(path("x = \"x' = eps*xi/sqrt(xi^2 + r^2)\"\ny = \"y' = eps*r/sqrt(xi^2 + r^2)\"\n"),
              "x - constant_x = r*cosh((y - constant_y)/r)");
    EXPECT_EQ(path("x = \"x' = eps*r/sqrt(xi^2 + r^2)\"\ny = \"y' = eps*b\"\n"),
              "y - constant_y = r*b*sinh((x - constant_x)/r)");
    EXPECT_EQ(path("x = \"x' = eps*r/sqrt(xi^2 + r^2)\"\ny = \"y' = eps*(b + xi/sqrt(xi^2 + r^2))\"\n"),
              "y - constant_y = r*(b + 1)/2*exp((x - constant_x)/r) - r*(b - 1)/2*exp(-(x - constant_x)/r)");
    EXPECT_EQ(path("x = \"x' = eps*xi\"\ny = \"y' = eps*b*xi\"\n"), "y - constant_y = b*(x - constant_x)");
    EXPECT_EQ(path("x = \"x' = eps*xi\"\ny = \"y' = eps\"\n"), "none"); // a parabola
    EXPECT_EQ(path("x = \"x' = eps^2\"\ny = \"y' = eps\"\n"), "none");
}

TEST(Transgression, OfThePendulumInLatex) {
    expect_part(print_transgression(solved(pendulum(4), 3), Format::latex), R"(
  \xi &= \xi_{0} + \varepsilon v t \\
  x &= C_{X} + r \ln \left(\frac{\xi + \sqrt{r^{2} + \xi^{2}}}{r}\right) + O\left(\varepsilon^{2}\right) \\
  y &= C_{Y} + \sqrt{r^{2} + \xi^{2}} + O\left(\varepsilon^{2}\right)
)");
}

// z = C_0 + eps*omega*(C2*C3 - C1*C4)*t, with u_x - i v_x = C1 + i C2.
TEST(Transgression, OfTheParticleIsUniform) {
    const std::string text = transgression_text("nonholonomic_particle", 3);
    expect_part(text, "\n  a1 = u_x + I*v_x\n");
    expect_part(text, "\n  z_z = constant_z + eps*sqrt(c)*(u_x*v_y - v_x*u_y)/sqrt(m)*t + O(eps^4)\n");
    expect_part(text, "\nz does not oscillate through order 3\n");
}

// With a force c*x + eps*b*x^3 the amplitudes turn, in the time 1/eps: the rates are averages.
TEST(Transgression, OfASlowFlowIsAveraged) {
    const std::string text = transgression_text("anharmonic_particle", 2);
    expect_part(text, "\nslow flow:\n  a1' = 3*I*b/(8*sqrt(m)*sqrt(c))*a1^2*a2*eps + O(eps^2)\n");
    expect_part(text,
                "\n  z_z' = -I*sqrt(c)/(2*sqrt(m))*a2*a3*eps + I*sqrt(c)/(2*sqrt(m))*a1*a4*eps + O(eps^3)\n");
}

// Amplitudes of the first approximation leave out eps in the time 1/eps.
TEST(Transgression, SaysWhatIsLeftOut) {
    const std::string text = transgression_text("steered_knife_edge", 2);
    expect_part(text, "\n  a1' = O(eps^2)\n");
    expect_part(text, "*t + O(eps)\n");
    expect_part(text, "\ny oscillates about its law: O(eps)\n");
}

// q moves by eps in the time 1/eps, and oscillates as much: the law is that of its mean.
TEST(Transgression, OfWhatOscillatesMoreThanItMoves) {
    const auto field = field_from("[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\n"
                                  "q = { role = \"drift\" }\nk = { role = \"drift\" }\n[equations]\n"
                                  "x = \"x'' + x = 0\"\nq = \"q' = x + eps^2\"\nk = \"k' = eps*x\"\n");
    const std::string text = print_transgression(solved(certified(field, 3), 2), Format::text);
    expect_part(text, "\nT = eps*t\n");
    expect_part(text, "\nz_q = constant_q + eps*T + O(eps^3)\n");
    expect_part(text, "\nk = constant_k + O(eps^2)\n");
    expect_part(text, "\nq oscillates about its law: O(eps)\n");
}

TEST(TransgressionJson, OfThePendulumIsRead) {
    const auto json = nlohmann::json::parse(print_transgression(solved(pendulum(4), 3), Format::json));
    EXPECT_EQ(json["schema"], "resonform.transgression/1");
    EXPECT_EQ(json["former_constants"][1],
              nlohmann::json::parse(R"({"variable": "x", "role": "drift", "oscillation": 2})"));
    EXPECT_EQ(json["slow"][0], nlohmann::json::parse(R"({"variable": "xi", "start": "xi_0", "rate": "v"})"));
    EXPECT_EQ(json["drift"].size(), 2U);
    EXPECT_EQ(json["drift"][1]["value"],
              nlohmann::json::parse(R"([{"eps": 0, "coefficient": "(r**2 + xi**2)**(1/2) + C_Y"}])"));
    EXPECT_EQ(json["drift"][1]["remainder"], 2);
    EXPECT_EQ(json["path"]["over"], "x");
    EXPECT_EQ(json["path"]["scale"], "r");
    EXPECT_EQ(json["path"]["rising"], "r/2");
    EXPECT_EQ(json["path"]["falling"], "r/2");
    EXPECT_EQ(json["path"]["offset"], "0");
    ASSERT_EQ(json["primitives"].size(), 1U); // those of later orders are left out
    EXPECT_EQ(json["primitives"][0]["kind"], "logarithm");
}

TEST(TransgressionJson, OfTheParticleIsRead) {
    const auto json = nlohmann::json::parse(
        print_transgression(solved(certified(field_named("nonholonomic_particle"), 3), 2), Format::json));
    ASSERT_EQ(json["uniform"].size(), 1U);
    EXPECT_EQ(json["uniform"][0]["constant"], "constant_z");
    EXPECT_EQ(json["uniform"][0]["rate"], "eps*sqrt(c)*(u_x*v_y - v_x*u_y)/sqrt(m)");
    EXPECT_EQ(json["amplitudes"][0],
              nlohmann::json::parse(R"({"mode": "z1", "real": "u_x", "imaginary": "v_x", "eps": 0})"));
    EXPECT_EQ(json["flow"][2]["remainder"], 4);
    EXPECT_EQ(json["flow"][0]["terms"].size(), 0U);
}

TEST(Transgression, IsOfWhatIsConstantAtEpsZero) {
    const Error error = error_when([&] { transgression_text("henon_heiles", 1); });
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    expect_part(error.what(), "stage transgression is of what is constant at eps = 0");
}

} // namespace
} // namespace resonform::test
