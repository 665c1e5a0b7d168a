// SPDX-License-Identifier: GPL-3.0-or-later
// Elementary integrals, each differentiated and compared exactly.
#include "model/integrals/antiderivative.hpp"

#include "mechanisms.hpp"
#include "model/files/read_system.hpp"
#include "model/signs/sign_prover.hpp"

namespace resonform {
namespace {

class Antiderivatives : public testing::Test {
protected:
    Antiderivatives() {
        domain_ = read_system_text("[system]\nname = \"s\"\n[parameters]\nr = { positive = true }\n"
                                   "a = { positive = true }\nb = {}\nc = {}\n"
                                   "[variables]\nu = { role = \"fast\" }\n[equations]\nu = \"u'' = -u\"\n",
                                   "system.toml");
        scope_ = domain_.constants();
        scope_.define("x", x_);
        for (const Parameter& p : domain_.parameters) form_.add(p.symbol, ExactForm::Kind::parameter);
        form_.add(x_, ExactForm::Kind::coordinate);
    }
    std::optional<GiNaC::ex> integral(const std::string& text) {
        return antiderivative(read_expression(text, scope_, {}), x_, [&](const GiNaC::ex& e) {
            return provably_positive(e.subs(x_ == 0), domain_);
        });
    }
    Zero is_integral(const std::string& text) {
        const auto f = integral(text);
        if (!f) return Zero::no;
        return form_.vanishes(f->diff(x_) - read_expression(text, scope_, {}));
    }

    System domain_;
    Scope scope_;
    GiNaC::symbol x_{"x"};
    ExactForm form_{domain_};
};

TEST_F(Antiderivatives, AreFound) {
    for (const char* text : {"0",
                             "3",
                             "b*x^3 + c",
                             "1/x",
                             "1/(r + x)",
                             "1/(x - 1)",
                             "1/(a*x + b)^3",
                             "x^2/(x^2 - 3*x + 2)",
                             "1/(x^2 + r^2)",
                             "(x^3 + 1)/(x^2 + r^2)^2",
                             "(b*x + c)/(x*(x^2 + 1))",
                             "1/(x^4 - 1)",
                             "1/(x^2 - r)",
                             "1/(x^2 + x + 1)^3",
                             "x^2*sqrt(r + x)",
                             "x/(1 + 2*x)^(3/2)",
                             "x^4*cos(a*x + b)",
                             "x^3*exp(-a*x)",
                             "x*sinh(x)",
                             "sin(x)^2",
                             "sin(x)*cos(2*x)",
                             "x*sin(a*x)^3*cos(a*x)",
                             "exp(a*x)*sin(r*x + b)",
                             "x^2*exp(-x)*cos(x)^2",
                             "cosh(x)^2*sinh(x)",
                             "tan(x)",
                             "tan(a*x + b)",
                             "tan(x)^2",
                             "1/cos(a*x)^2",
                             "1/cos(x)",
                             "sin(x)^3/cos(x)^2",
                             "1/(r + 1 + r*sin(x)^2)*cos(x)",
                             "tanh(x)",
                             "1/cosh(x)^2",
                             "log(r + x)",
                             "x*log(1 + a*x)",
                             "atan(x/r)",
                             "x^2*atan(x)",
                             "x*exp(-x^2)",
                             "x*sqrt(x^2 + r^2)",
                             "x/(x^2 + r^2)^(3/2)",
                             "cos(x)*exp(sin(x))",
                             "exp(x)/(1 + exp(x))",
                             "cos(x)*sqrt(1 + r*sin(x))",
                             "x*sin(x^2)^2"})
        EXPECT_EQ(is_integral(text), Zero::yes) << text;
}

// Not elementary, of a sign that nothing proves, or of an arc that jumps.
TEST_F(Antiderivatives, AreNotClaimed) {
    for (const char* text : {"exp(-x^2)", "sin(x)/x", "1/(x^2 + b)", "sqrt(1 + x^3)", "1/(2 + cos(x)^2)",
                             "1/(x^3 + r)", "sin(x^2)", "1/((b - c)*x + 1)", "sin((b - c)*x)"})
        EXPECT_FALSE(integral(text)) << text;
}

// |x - 1| where x is about 0.
TEST_F(Antiderivatives, AreReal) {
    const GiNaC::symbol& x = x_;
    EXPECT_TRUE(integral("1/(x - 1)")->subs(x == 0).is_zero());
    EXPECT_TRUE(integral("1/x")->is_equal(GiNaC::log(GiNaC::pow(x, 2)) / 2));
}

} // namespace
} // namespace resonform
