// SPDX-License-Identifier: GPL-3.0-or-later
// What the reader makes of an expression, and what it refuses.
#include "model/text/expression.hpp"
#include "model/text/function_call.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::pow;

class Expression : public testing::Test {
protected:
    Expression() {
        scope.define("x", x);
        scope.define_derivative("x", 1, x1);
        scope.define("xi", xi);
        scope.define("r", r);
    }

    ex read(const std::string& text) const { return read_expression(text, scope, source_of(text)); }

    static SourceText source_of(const std::string& text) {
        SourceText source;
        source.file = "file.toml";
        source.key = "equations.x";
        source.line = 7;
        source.column = 1;
        source.source_line = text;
        return source;
    }

    // rule | found | hint, and the column.
    std::string complaint(const std::string& text) const {
        try {
            read(text);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::bad_input);
            EXPECT_LE(std::string(error.what()).size(), 2048U);
            const Diagnostic& d = error.diagnostic();
            return std::to_string(d.place.column) + ": " + d.rule + " | " + d.value + " | " + d.hint;
        }
        return "";
    }

    GiNaC::symbol x{"x"}, x1{"x'"}, xi{"xi"}, r{"r"};
    Scope scope;
};

TEST_F(Expression, NumbersAreExact) {
    EXPECT_EQ(read("0.1 + 0.2"), numeric(3, 10));
    EXPECT_EQ(read("1.5e-3"), numeric(3, 2000));
    EXPECT_EQ(read("2E2"), numeric(200));
    EXPECT_EQ(read("1/3 + 1/6"), numeric(1, 2));
}

TEST_F(Expression, PrecedenceIsTheUsualOne) {
    EXPECT_EQ(read("-x^2"), -pow(x, 2));
    EXPECT_EQ(read("(-x)^2"), pow(x, 2));
    EXPECT_EQ(read("2^3^2"), numeric(512));
    EXPECT_EQ(read("2**3**2"), numeric(512));
    EXPECT_EQ(read("x^-2"), pow(x, -2));
    EXPECT_EQ(read("2*-x"), -2 * x);
    EXPECT_EQ(read("x - -x"), 2 * x);
    EXPECT_EQ(read("12/2/3"), numeric(2));
    EXPECT_EQ(read("x - r - xi"), x - r - xi);
    EXPECT_EQ(read("x/r*xi"), x * xi / r);
    EXPECT_EQ(read("-r^xi^2"), -exp(pow(xi, 2) * log(r)));
    EXPECT_EQ(read("2^(r - r)"), numeric(1));
}

TEST_F(Expression, PrimesAreDerivatives) {
    EXPECT_EQ(read("x' - x"), x1 - x);
    EXPECT_EQ(read_equation("x' = r*x", scope, source_of("")), x1 - r * x);
}

TEST_F(Expression, FunctionsAndPi) {
    EXPECT_EQ(read("sin(x) + cos(x) + tan(x)"), sin(x) + cos(x) + tan(x));
    EXPECT_EQ(read("exp(x) + log(x) + sqrt(x)"), exp(x) + log(x) + sqrt(x));
    EXPECT_EQ(read("sinh(x) + cosh(x) + tanh(x)"), sinh(x) + cosh(x) + tanh(x));
    EXPECT_EQ(read("asin(x) + atan(x)"), asin(x) + atan(x));
    EXPECT_EQ(read("acos(x)"), GiNaC::Pi / 2 - asin(x));
    EXPECT_EQ(read("asinh(x) + acosh(x) + atanh(x)"), asinh(x) + acosh(x) + atanh(x));
    EXPECT_EQ(read("erf(0) + erf(x) + erf(-1) + erf(1)"), call(Function::error_function, x));
    EXPECT_EQ(complaint("acosh(1/2)"),
              "6: acosh of this number is not real | (1/2) | write the real value meant");
    EXPECT_NE(complaint("atanh(2)"), "");
    EXPECT_NE(complaint("atanh(1)"), "");
    EXPECT_EQ(read("sin(pi/6)"), numeric(1, 2));
    EXPECT_EQ(read("(xi^2 + r^2)^(1/4)"), pow(xi * xi + r * r, numeric(1, 4)));
}

TEST_F(Expression, HighestPrimes) {
    const std::string text = "(xi^2)*psi'' + psi'''*psi - sin(xi')";
    const std::map<std::string, int> expected{{"psi", 3}, {"sin", 0}, {"xi", 1}};
    EXPECT_EQ(highest_primes(text, source_of(text)), expected);
}

TEST_F(Expression, MessagesHaveTheWholeStory) {
    const Error error = test::error_when([&] { read("r*xj + 2"); });
    EXPECT_STREQ(error.what(), "file.toml:7:3: equations.x: unknown symbol\n"
                               "    r*xj + 2\n"
                               "      ^\n"
                               "  found: xj\n"
                               "  hint:  did you mean 'x'? Known are: r, x, xi");
}

TEST_F(Expression, SyntaxErrors) {
    EXPECT_EQ(complaint(""), "1: the expression is empty | \"\" | write one");
    EXPECT_EQ(complaint("2x"), "1: a product is written without '*' | 2x | write 2*x");
    EXPECT_EQ(complaint("r cos(x)"), "1: a product is written without '*' | r cos | write r*cos");
    EXPECT_EQ(complaint("xi(x)"), "1: a product is written without '*' | xi( | write xi*(");
    EXPECT_EQ(complaint("(x"), "1: a '(' is not closed | ( | add the ')' or remove the '('");
    EXPECT_EQ(complaint("x)"), "2: a ')' closes nothing | ) | remove it or add the '('");
    EXPECT_EQ(complaint("()"), "1: parentheses hold an expression | () | write one or remove them");
    EXPECT_EQ(complaint("x +* r"),
              "3: something stands after '+' | +* | write the missing number, name or '('");
    EXPECT_EQ(complaint("r +"), "3: something stands after '+' | + | write the missing number, name or '('");
    EXPECT_EQ(complaint("x = 1"), "3: an expression here has no '=' | = | give the value alone");
    EXPECT_EQ(complaint("x, r"), "2: an expression holds a comma | , | "
                                 "write decimals with a point; functions take one argument");
    EXPECT_EQ(complaint(".5"),
              "1: a number has a digit before and after its decimal point | .5 | write 0.5 or 1.0");
}

TEST_F(Expression, NamesAndFunctions) {
    EXPECT_EQ(complaint("x''"), "1: 'x' is known here with at most 1 primes | x'' | write fewer");
    EXPECT_EQ(complaint("r'"), "1: 'r' has no derivative here | r' | remove the primes");
    EXPECT_EQ(complaint("sin x"),
              "1: the argument of a function is not in parentheses | sin | write sin(...)");
    EXPECT_EQ(complaint("sin'(x)"), "1: primes follow a name that is not a variable | sin' | "
                                    "write the derivative of sin in full");
    EXPECT_EQ(complaint("E"), "1: unknown symbol | E | write exp(1)");
    EXPECT_EQ(complaint("sim(x)"),
              "1: unknown function | sim | did you mean 'sin'? Known are: sin, cos, tan, "
              "exp, log, sqrt, sinh, cosh, tanh, asin, acos, atan, asinh, acosh, atanh, erf");
    EXPECT_EQ(complaint("zeta(10^9)"),
              "1: unknown function | zeta | known are: sin, cos, tan, exp, log, sqrt, "
              "sinh, cosh, tanh, asin, acos, atan, asinh, acosh, atanh, erf");
}

TEST_F(Expression, SignsOfThePaperAreNamedInAscii) {
    const std::string rule =
        ": an expression is written with ASCII letters, digits, + - * / ^ ' ( ) = and spaces | ";
    EXPECT_EQ(complaint("r*ψ"), "3" + rule + "ψ | write psi");
    EXPECT_EQ(complaint("x − r"), "3" + rule + "− | write -");
    EXPECT_EQ(complaint("x²"), "2" + rule + "² | write ^2");
    EXPECT_EQ(complaint("x\""), "2" + rule + "\" | write '' (two apostrophes) for a second derivative");
    EXPECT_EQ(complaint("x$"), "2" + rule + "$ | remove it or spell it in ASCII");
}

TEST_F(Expression, SingularAndComplexValues) {
    const std::string zero = ": a denominator is zero | ";
    const std::string hint = " | this expression is zero for all values: correct it";
    EXPECT_EQ(complaint("1/(xi - xi)"), "3" + zero + "(xi - xi)" + hint);
    EXPECT_EQ(complaint("1/((xi+1)^2-xi^2-2*xi-1)"), "3" + zero + "((xi+1)^2-xi^2-2*xi-1)" + hint);
    EXPECT_EQ(complaint("x/0"), "3" + zero + "0" + hint);
    EXPECT_EQ(complaint("0^0"), "1: zero is raised to positive powers only | 0^0 | "
                                "the base is zero for all values: correct it");
    EXPECT_EQ(complaint("log(x-x)"), "4: log has no value at zero | (x-x) | correct the argument");
    EXPECT_EQ(complaint("sqrt(-1)"),
              "5: sqrt of this number is not real | (-1) | write the real value meant");
    EXPECT_EQ(complaint("(-8)^(1/3)"),
              "1: a fractional power of a negative number is not real | (-8)^(1/3) | "
              "write the real value meant");
    EXPECT_EQ(complaint("asin(2)"), "5: asin of this number is not real | (2) | write the real value meant");
    EXPECT_EQ(complaint("tan(pi/2)"),
              "1: the expression has no value | tan(pi/2) | it is singular here: correct it");
}

TEST_F(Expression, LimitsAreCheckedBeforeAnythingIsComputed) {
    const std::string exponent = ": an exponent is a fraction of integers of at most 1000 | ";
    EXPECT_EQ(complaint("1e999999999"),
              "1: a number has at most 1000 digits, its decimal exponent included | "
              "1e999999999 | write a shorter number, or a parameter in its place");
    EXPECT_EQ(complaint("2^(10^9)"), "3" + exponent + "(10^9) | use a smaller exponent");
    EXPECT_EQ(complaint("(1+x)^100000"), "7" + exponent + "100000 | use a smaller exponent");
    EXPECT_EQ(complaint("10^10^10"), "4" + exponent + "10^10 | use a smaller exponent");
    EXPECT_EQ(complaint("((2^1000)^1000)^1000"),
              "2: the numbers of an expression stay below 2^100000 when it is expanded | (2^1000)^1000 | "
              "use smaller numbers or exponents");
    EXPECT_EQ(complaint("(1+x+xi+r)^900"),
              "1: an expression has at most 100000 terms when it is expanded | "
              "(1+x+xi+r)^900 | use smaller exponents or fewer products of sums");
    EXPECT_EQ(complaint("((x^100)^100)^2"), "1: an expression is at most of degree 10000 | ((x^100)^100)^2 | "
                                            "use smaller exponents");
    EXPECT_EQ(complaint("0^r"), "1: log has no value at zero | 0 | correct the argument");
    EXPECT_EQ(complaint("(-2)^r"), "1: log of this number is not real | (-2) | write the real value meant");
}

std::string repeated(const std::string& text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i) result += text;
    return result;
}

// Deep, long and wide texts overflow no stack, and end long before a test is ended.
TEST_F(Expression, HostileTextsAreAnswered) {
    const std::string deep = "parentheses, functions and powers nest at most 200 deep";
    const std::string wide = "an expression has at most 100000 bytes";
    const auto rule = [this](const std::string& text) {
        const std::string c = complaint(text);
        const std::size_t from = c.find(": ");
        return c.substr(from + 2, c.find(" | ") - from - 2);
    };
    EXPECT_EQ(rule(repeated("(", 49000) + "x" + repeated(")", 49000)), deep);
    EXPECT_EQ(rule(repeated("sin(", 19000) + "x" + repeated(")", 19000)), deep);
    EXPECT_EQ(rule("2" + repeated("^2", 49000)), deep);
    EXPECT_EQ(rule(repeated("(", 100000) + "x" + repeated(")", 100000)), wide);
    EXPECT_EQ(rule("x" + repeated("+x", 500000)), wide);
    EXPECT_EQ(read(repeated("-", 99999) + "x"), -x);
    EXPECT_EQ(read("x" + repeated("+x", 49999)), 50000 * x);
    EXPECT_EQ(rule("x" + repeated("*x", 49999)), "an expression is at most of degree 10000");
    EXPECT_EQ(rule("(2^1000)^99" + repeated("+(2^1000)^99", 8000)),
              "the numbers of an expression stay below 2^100000 when it is expanded");
}

TEST_F(Expression, EquationsHaveOneSign) {
    const auto rule = [this](const std::string& text) -> std::string {
        try {
            read_equation(text, scope, source_of(text));
        } catch (const Error& error) {
            return error.diagnostic().rule;
        }
        return "";
    };
    EXPECT_EQ(rule("x' = r"), "");
    EXPECT_EQ(rule("x' + r"), "the equation does not have exactly one '='");
    EXPECT_EQ(rule("x' = r = 2"), "the equation does not have exactly one '='");
    EXPECT_EQ(rule("= r"), "an expression begins with none of number, name, sign and '('");
    EXPECT_EQ(rule("x' ="), "something stands after '='");
}

TEST(Nearest, SuggestsWhatIsClose) {
    EXPECT_EQ(nearest("oder", {"outputs", "order"}), "order");
    EXPECT_EQ(nearest("fial", {"pass", "fail"}), "fail");
    EXPECT_EQ(nearest("foo", {"cos"}), "");
    EXPECT_EQ(nearest("", {"x"}), "");
    EXPECT_EQ(nearest(std::string(100000, 'x'), {"x"}), "");
}

} // namespace
} // namespace resonform
