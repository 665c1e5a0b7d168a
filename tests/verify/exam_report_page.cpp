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
               Gallery{{{"name", "<svg></svg>", "what it shows"}}}}}}};
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
    EXPECT_NE(html.find("<td class=\"fail\">fail</td>"), std::string::npos);
    EXPECT_NE(html.find("<figure><svg></svg><figcaption>what it shows</figcaption></figure>"),
              std::string::npos);
    EXPECT_EQ(count(html, std::regex("<script|src=|<link|@import|url\\(")), 0U) << "loads something";
}

TEST(ReportPage, MarkdownRefersToItsFigures) {
    EXPECT_EQ(to_markdown(page()), "# A &lt; B\n\na &amp; b\n\n## First\n\ntext\n\n```\nz' = \"w\"\n```\n\n"
                                   "**caption**\n\n| output | verdict |\n| --- | ---: |\n| x\\|y | pass |\n"
                                   "| z | fail |\n\n![what it shows](figures/name.svg)\n\n");
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
    EXPECT_GT(ids.size(), 4U);
}

} // namespace resonform::report
