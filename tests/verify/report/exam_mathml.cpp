// SPDX-License-Identifier: GPL-3.0-or-later
// The LaTeX of the engine, as MathML.
#include "verify/report/mathml.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace resonform::report {

namespace {

std::string inside(const std::string& latex) {
    const std::string begin = "<math displaystyle=\"true\">", all = to_mathml(latex);
    EXPECT_EQ(all.compare(0, begin.size(), begin), 0) << all;
    return all.substr(begin.size(), all.size() - begin.size() - std::string("</math>").size());
}

using Terms = std::vector<std::string>;

} // namespace

TEST(MathML, OfTheLatexThatIsWritten) {
    EXPECT_EQ(inside("z_{1}^{2}"),
              "<msubsup><mi>z</mi><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></msubsup>");
    EXPECT_EQ(inside("\\frac{1}{\\sqrt{g}}"),
              "<mfrac><mrow><mn>1</mn></mrow><mrow><msqrt><mrow><mi>g</mi></mrow></msqrt></mrow></mfrac>");
    EXPECT_EQ(inside("\\left(a - b\\right)^{2}"),
              "<msup><mrow><mo stretchy=\"true\">(</mo><mi>a</mi><mo>−</mo><mi>b</mi><mo "
              "stretchy=\"true\">)</mo></mrow><mrow><mn>2</mn></mrow></msup>");
    EXPECT_EQ(inside("\\varepsilon \\xi"), "<mi>ε</mi><mi>ξ</mi>");
    EXPECT_EQ(inside("\\int\\limits_{0}^{t}"),
              "<munderover><mo largeop=\"true\">∫</mo><mrow><mn>0</mn></mrow>"
              "<mrow><mi>t</mi></mrow></munderover>");
    EXPECT_EQ(inside("\\sin \\psi"), "<mi>sin</mi><mspace width=\"0.17em\"/><mi>ψ</mi>");
    EXPECT_EQ(inside("\\mathrm{lam}"), "<mi mathvariant=\"normal\">lam</mi>");
    EXPECT_EQ(inside("+ a"), "<mo form=\"infix\">+</mo><mi>a</mi>");
    EXPECT_NE(inside("\\dot{\\xi}").find("˙"), std::string::npos);
}

TEST(MathML, EndsWhateverItReads) {
    for (const char* text : {"", "}", "\\frac{", "\\left(", "a^", "\\", "\\right)", "{{", "_"})
        (void)to_mathml(text);
    EXPECT_EQ(inside("a < b"), "<mi>a</mi><mo>&lt;</mo><mi>b</mi>");
}

TEST(MathML, LinesBreakBetweenTerms) {
    const std::vector<FormulaLine> lines =
        formula_lines("% solution\n\\begin{align*}\n  x &= a + \\left(b - c\\right) d \\\\\n"
                      "  &\\quad - \\frac{1 + e}{2} \\\\\n  y &= 0\n\\end{align*}\nwhere:\n");
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].terms, (Terms{"x =", " a ", "+ \\left(b - c\\right) d ", "- \\frac{1 + e}{2} "}));
    EXPECT_EQ(lines[1].terms, (Terms{"y =", " 0"}));
    EXPECT_EQ(lines[2].words, "where:");
    EXPECT_TRUE(lines[2].terms.empty());
}

} // namespace resonform::report
