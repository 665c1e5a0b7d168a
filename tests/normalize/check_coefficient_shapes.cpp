// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients that mean something simple and are written, or come out, in another shape: roots of products
// inside of roots, squares under roots, divisors that are quotients or have a known factor. Each system is
// derived and certified.
#include "model/files/read_system.hpp"
#include "normalize/certified.hpp"
#include "normalize/recursion/numbers.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

struct Shape {
    const char* name;
    const char* parameters;
    const char* variables;
    const char* equations;
    int order = 3;
    const char* domain = "";
};

std::ostream& operator<<(std::ostream& out, const Shape& s) { return out << s.name; }

std::string file_of(const Shape& s) {
    const std::string domain = *s.domain == 0 ? "" : "[domain]\npositive = [" + std::string(s.domain) + "]\n";
    return "[system]\nname = \"shape\"\n[parameters]\n" + std::string(s.parameters) + "[variables]\n" +
           s.variables + domain + "[equations]\n" + s.equations;
}

const char* const one = "x = { role = \"fast\" }\n";
const char* const two = "x = { role = \"fast\" }\ny = { role = \"fast\" }\n";
const char* const a_b = "a = { positive = true }\nb = { positive = true }\n";

const Shape shapes[] = {
    {"RootOfAProductInASum", a_b, one, "x = \"x'' + x = x^3/(1 + sqrt(a*b))\"\n"},
    {"RootOfSixInASum", "", one, "x = \"x'' + (1 + sqrt(6))*x = x^3/(2 + sqrt(12))\"\n"},
    {"RootOfAQuotientInASum", a_b, one, "x = \"x'' + x = x^3/(2 + sqrt(a/b)) + x^3*log(1 + sqrt(6))\"\n"},
    {"NestedRootsOfNumbers", "", two, "x = \"x'' + 3*x - y + x*y = 0\"\ny = \"y'' + 5*y - x/2 + x^2 = 0\"\n",
     2},
    {"SquareUnderARoot", "k = { positive = true }\nc = { positive = true }\n", two,
     "x = \"x'' + k*x + c*(x - y) + x^3 = 0\"\ny = \"y'' + k*y - c*(x - y) = 0\"\n"},
    {"SlowSquareUnderARoot", "k = { positive = true }\n",
     "x = { role = \"fast\" }\ny = { role = \"fast\" }\ntau = { role = \"slow\", positive = true }\n",
     "x = \"x'' + k*x + tau*(x - y) + x^3 = 0\"\ny = \"y'' + k*y - tau*(x - y) = 0\"\ntau = \"tau' = "
     "eps\"\n"},
    {"UnequalMasses", "m = { positive = true }\nk = { positive = true }\n", two,
     "x = \"x'' + 2*k*x - k*y = 0\"\ny = \"m*y'' + 2*k*y - k*x + x^2 = 0\"\n", 2, "\"1 - m + m^2\""},
    {"SquareOfADifference", "w = { positive = true }\nc = { positive = true }\n",
     "x = { role = \"fast\" }\np = { role = \"fast\" }\ny = { role = \"fast\" }\nq = { role = \"fast\" }\n",
     "x = \"x' = w*p - c*y\"\np = \"p' = -w*x - c*q - 2*x*y\"\ny = \"y' = w*q + c*x\"\n"
     "q = \"q' = -w*y + c*p - x^2\"\n",
     2, "\"w - c\""},
    {"EigenvalueThatIsAQuotient", "a = { positive = true }\n", two,
     "x = \"x' = x + x*y\"\ny = \"(1 + a)*y' = -y + x^2\"\n"},
    {"FrequenciesThatAreQuotients", a_b, two,
     "x = \"(1 + a)*x'' + x = y^2\"\ny = \"(1 + b)^2*y'' + y = x^2\"\n"},
    {"DampingThatIsAQuotient", "m = { positive = true }\n", one, "x = \"x'' + 2*x'/(1 + m) + 5*x = x^3\"\n"},
    {"FrequencyOfAnAngleThatIsAQuotient", "",
     "J = { role = \"slow\" }\np = { role = \"angle\" }\nq = { role = \"angle\" }\n",
     "J = \"J' = eps*cos(p + q)\"\np = \"p' = 1/(1 + J)\"\nq = \"q' = 1\"\n", 2, "\"1 + J\""},
    {"DivisorWithAKnownFactor", "p = { positive = true }\n", two,
     "x = \"x' = -(2 + p^2)*x + y^3/(1 + p^2)\"\ny = \"y'' + p^2*y = x*y\"\n"},
    {"CoupledBlocksOfSymbols", "g = { positive = true }\n",
     "x = { role = \"fast\" }\ny = { role = \"fast\" }\np = { role = \"fast\" }\nq = { role = \"fast\" }\n",
     "x = \"x' = p\"\ny = \"y' = q\"\np = \"p' + (2 + g)*x - y + x*y = 0\"\nq = \"q' + y - x = 0\"\n", 2},
    {"WeightsWithTheRootOfASum", "s = { positive = true }\n",
     "x = { role = \"fast\" }\ny = { role = \"fast\", weight = 2 }\n",
     "x = \"x'' + (1 + s)*x = x^2\"\ny = \"y' = -y\"\n"},
    {"ANumberWithManyPrimeFactors", "", one, "x = \"x'' + 7420738134810*x = x^3\"\n"},
};

class CoefficientShapes : public testing::TestWithParam<Shape> {};

TEST_P(CoefficientShapes, AreDerivedAndCertified) {
    const Normalization n = normalize_poincare(test::field_from(file_of(GetParam())), GetParam().order);
    const Certificate c = certify(n.normal_form, n.map);
    EXPECT_TRUE(c.holds) << c.complaint;
}

INSTANTIATE_TEST_SUITE_P(All, CoefficientShapes, testing::ValuesIn(shapes),
                         [](const testing::TestParamInfo<Shape>& shape) { return shape.param.name; });

// Modes k and k + 2 c: no root of c^2 is left in the frequencies.
TEST(CoefficientShape, EqualOscillatorsCoupledBySpringsHaveSimpleFrequencies) {
    const auto field = test::field_from(file_of(shapes[4]));
    const Ring& ring = *field->ring;
    const Polynomial k = ring.gen(*ring.find("k")), c = ring.gen(*ring.find("c"));
    ASSERT_EQ(field->modes.size(), 2U);
    EXPECT_TRUE(ring.vanishes(ring.power(field->modes[0].omega, 2) - k));
    EXPECT_TRUE(ring.vanishes(ring.power(field->modes[1].omega, 2) - k - Rational(2) * c));
}

// Both derivatives of frequencies known by name and a graph: the derivatives are there when they are needed.
TEST(CoefficientShape, NamedFrequenciesInAGraph) {
    const auto field = test::field_from(
        "[system]\nname = \"shape\"\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n"
        "tau = { role = \"slow\" }\n[functions]\no1 = { of = [\"tau\"], positive = true }\n"
        "o2 = { of = [\"tau\"], positive = true }\n[equations]\nx = \"x'' + o1(tau)^2*x + x*y = 0\"\n"
        "y = \"y'' + o2(tau)^2*y + x^2/2 = 0\"\ntau = \"tau' = eps\"\n");
    const GraphNormalization n = normalize_in_graph(field, 4);
    const Certificate c = certify(n);
    EXPECT_TRUE(c.holds) << c.complaint;
}

// |D| = 2 sqrt(2) - 2 is 3e-57 above the threshold, the next one 1e-6: only that is on a side.
TEST(CoefficientShape, ADivisorOnTheThresholdIsRefused) {
    const auto system = [](const std::string& near, int digits) {
        System s = read_system_text(
            "[system]\nname = \"near\"\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n"
            "[equations]\nx = \"x'' + x = x*y^2\"\ny = \"y'' + 2*y = x^2*y\"\n[normal_form]\nnear = " +
                near + "\n",
            "test/system.toml");
        s.digits = digits;
        return std::make_shared<const System>(std::move(s));
    };
    const auto derive = [&](const std::string& near, int digits) {
        const auto field = std::make_shared<const GradedField>(
            expand(std::make_shared<const FirstOrderSystem>(solve_for_highest(system(near, digits)))));
        return digits == 0 ? normalize_poincare(field, 3) : normalize_in_numbers(field, 3);
    };
    for (const int digits : {0, 20}) {
        EXPECT_THROW(derive("0.82842712474619009760337744841939615713934375075389614635", digits), Error);
        const Normalization n = derive("0.828426", digits);
        EXPECT_TRUE(std::none_of(n.divisors.begin(), n.divisors.end(), [](const DivisorRecord& d) {
            return d.verdict == DivisorVerdict::kept_near;
        }));
    }
}

} // namespace
} // namespace resonform
