// SPDX-License-Identifier: GPL-3.0-or-later
// How a page is spelled in HTML and Markdown, and that a plot is a piece of a page.
#include "verify/report/page.hpp"
#include "verify/report/plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <regex>

namespace resonform::report {

namespace {

Page page() {
    return {"A < B",
            "a & b",
            {{"First",
              {Paragraph{"text"}, Preformatted{"z' = \"w\"\n"},
               Table{"caption", {"output", "verdict"}, {{"x|y", "pass"}, {"z", "fail"}}},
               Gallery{{{"name", "<svg></svg>", "what it shows", "x,y\n"}}},
               Statements{{{"fail", "x is third order"}, {"note", "a < b"}}}, Facts{{{"g", "9.81 m/s²"}}},
               Formulas{"\\begin{align*}\n  x &= a + b\n\\end{align*}\n", "x = a + b\n"}}}}};
}

std::size_t count(const std::string& text, const std::regex& what) {
    return static_cast<std::size_t>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), what), std::sregex_iterator()));
}

} // namespace

TEST(ReportPage, HtmlStandsAlone) {
    const std::string html = to_html(page());
    EXPECT_NE(html.find("<h1>A &lt; B</h1>"), std::string::npos);
    EXPECT_NE(html.find("z' = &quot;w&quot;"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"fail\" data-header=\"verdict\">fail</td>"), std::string::npos);
    EXPECT_NE(html.find("<figure><svg></svg><figcaption>what it shows <a class=\"numbers\" "
                        "href=\"figures/name.csv\">CSV</a></figcaption></figure>"),
              std::string::npos);
    EXPECT_NE(html.find("<span class=\"word fail\">fail</span> <span>x is third order</span>"),
              std::string::npos);
    EXPECT_NE(html.find("<span class=\"word \">note</span> <span>a &lt; b</span>"), std::string::npos);
    EXPECT_NE(html.find("<dt>g</dt><dd>9.81 m/s²</dd>"), std::string::npos);
    EXPECT_EQ(count(html, std::regex("<math")), 3U) << "x =, a, + b";
    EXPECT_EQ(count(html, std::regex("<script|src=|<link|@import|url\\(")), 0U) << "loads something";
}

TEST(ReportPage, MarkdownRefersToItsFigures) {
    EXPECT_EQ(to_markdown(page()), "# A &lt; B\n\na &amp; b\n\n## First\n\ntext\n\n```\nz' = \"w\"\n```\n\n"
                                   "**caption**\n\n| output | verdict |\n| --- | ---: |\n| x\\|y | pass |\n"
                                   "| z | fail |\n\n![what it shows](figures/name.svg)\n\n"
                                   "- **fail**: x is third order\n- **note**: a &lt; b\n\n"
                                   "| | |\n| --- | --- |\n| g | 9.81 m/s² |\n\n```\nx = a + b\n```\n\n");
}

TEST(ReportPage, NumbersAreShort) {
    EXPECT_EQ(short_number(0.00253), "2.53·10⁻³");
    EXPECT_EQ(short_number(-1.5e12), "-1.50·10¹²");
    EXPECT_EQ(short_number(0.01), "0.01");
    EXPECT_EQ(short_number(12.345), "12.3");
    EXPECT_EQ(short_number(1234), "1.23·10³");
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(std::numeric_limits<double>::quiet_NaN()), "–");
}

TEST(ReportPage, NamesAreReadAsLetters) {
    EXPECT_EQ(pretty("psi"), "ψ");
    EXPECT_EQ(pretty("psi'"), "ψ'");
    EXPECT_EQ(pretty("theta_0"), "θ_0");
    EXPECT_EQ(pretty("psix"), "psix");
    EXPECT_EQ(pretty("p"), "p");
    EXPECT_EQ(pretty("C_delta"), "C_δ");
}

TEST(ReportPage, WhatTheTerminalPrintsIsTypeset) {
    EXPECT_EQ(typeset("max|psi| -> 2.5e-03 eps^3 on t <= 1/eps"), "max|ψ| → 2.5·10⁻³ ε³ on t ≤ 1/ε");
    EXPECT_EQ(typeset("tolerance 1e-08, x1e5 at eps^(7/2) ... eps^-12"),
              "tolerance 10⁻⁸, x1e5 at ε^(7/2) … ε⁻¹²");
    EXPECT_EQ(power_of_eps(Rational(4)), "ε⁴");
    EXPECT_EQ(power_of_eps(Rational(7) / 2), "ε^(7/2)");
    EXPECT_EQ(plain_number(0.0005), "0.0005");
    EXPECT_EQ(plain_number(1e6), "10⁶");
}

// A row becomes a list on a telephone, and what is folded opens on paper.
TEST(ReportPage, IsForDarknessTelephonesAndPaper) {
    const std::string style = page_style;
    for (const char* part :
         {"prefers-color-scheme: dark", "max-width: 44rem", "@media print", "details-content"})
        EXPECT_NE(style.find(part), std::string::npos) << part;
}

TEST(Plot, HasItsNumbersAsCsv) {
    Plot plot{"name", "t, s", "x", false, false, {}};
    plot.curves.push_back({"a", colour::red, Curve::Style::line, {0, 1}, {2, -3e-20}});
    EXPECT_EQ(to_csv(plot), "quantity,curve,\"t, s\",value\n\"x\",\"a\",0,2\n\"x\",\"a\",1,-3e-20\n");
    plot.below_label = "Δx";
    plot.below.push_back({"\"b\"", colour::red, Curve::Style::line, {5}, {6}, {"N = 1"}, {4}, {7}});
    EXPECT_EQ(to_csv(plot), "quantity,curve,\"t, s\",value,mark,low,high\n\"x\",\"a\",0,2,,,\n"
                            "\"x\",\"a\",1,-3e-20,,,\n\"Δx\",\"\"\"b\"\"\",5,6,\"N = 1\",4,7\n");
}

TEST(Plot, HasASecondPanelInItsOwnPowerOfTen) {
    const auto scratch = std::filesystem::temp_directory_path() / "resonform-plots";
    Plot plot{"panels", "t", "x", false, false, {}};
    plot.curves.push_back({"above", colour::red, Curve::Style::wide, {0, 1, 2}, {1, 2, 3}});
    plot.below_label = "Δx, m";
    plot.below.push_back({"", colour::blue, Curve::Style::line, {0, 1, 2}, {1e-9, 4e-9, 2e-9}});
    const std::string svg = to_svg(plot, scratch);
    EXPECT_NE(svg.find("Δx, 10"), std::string::npos);
    EXPECT_EQ(svg.find("10<tspan dy=\"5.00px\">"), std::string::npos);
    EXPECT_EQ(count(svg, std::regex("×")), 0U) << "a power at a tic";
}

TEST(Plot, IsAnElementWithItsOwnIds) {
    const auto scratch = std::filesystem::temp_directory_path() / "resonform-plots";
    Plot plot{"first", "t", "x \"quoted\"", false, true, {}};
    plot.curves.push_back({"curve", colour::red, Curve::Style::line_points, {0, 1, 2, 3}, {1, -1, 1e-3, 2}});
    const std::string first = to_svg(plot, scratch);
    plot.name = "second";
    const std::string second = to_svg(plot, scratch);
    EXPECT_EQ(first.compare(0, 4, "<svg"), 0);
    EXPECT_EQ(first.find("<script"), std::string::npos);
    EXPECT_NE(first.find("curve"), std::string::npos);
    const std::regex id("id=.([^'\"]*)");
    const std::string both = first + second;
    std::vector<std::string> ids;
    for (std::sregex_iterator at(both.begin(), both.end(), id), end; at != end; ++at) ids.push_back((*at)[1]);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end()) << "an id stands twice on one page";
    EXPECT_GT(ids.size(), 3U);
}

// What is taken out of the SVG leaves a document: every tag is closed, attributes are apart, and marks are
// there.
TEST(Plot, IsADocumentWithAllOfItsMarks) {
    const auto scratch = std::filesystem::temp_directory_path() / "resonform-plots";
    Plot plot{"marks", "ε", "x", true, true, {}, "note", {}, {}};
    plot.curves.push_back({"one",
                           colour::red,
                           Curve::Style::line_points,
                           {1, 10, 100},
                           {1, 2, 3},
                           {"N = 1", "", "N = 3"},
                           {0.9, 9, 90},
                           {1.1, 11, 110}});
    plot.curves.push_back({"none", colour::blue, Curve::Style::line, {}, {}});
    const std::string svg = to_svg(plot, scratch);
    std::vector<std::string> open;
    const std::regex tag("<(/?)([a-z]+)((?:\\s+[a-zA-Z:-]+=(?:\"[^\"]*\"|'[^']*'))*)\\s*(/?)>");
    std::string rest;
    std::size_t end = 0;
    for (std::sregex_iterator at(svg.begin(), svg.end(), tag), last; at != last; ++at) {
        rest += svg.substr(end, static_cast<std::size_t>(at->position()) - end);
        end = static_cast<std::size_t>(at->position() + at->length());
        if ((*at)[1].length() > 0) {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ(open.back(), (*at)[2].str());
            open.pop_back();
        } else if ((*at)[4].length() == 0) {
            open.push_back((*at)[2]);
        }
    }
    EXPECT_TRUE(open.empty()) << svg;
    EXPECT_EQ(rest.find('<'), std::string::npos) << rest;
    EXPECT_NE(rest.find("N = 1"), std::string::npos);
    EXPECT_NE(rest.find("N = 3"), std::string::npos);
    EXPECT_EQ(count(svg, std::regex("<use [^>]*scale")), 4U) << "three points, and the legend: " << svg;
    EXPECT_LT(svg.size(), 8000U);
}

} // namespace resonform::report
