// SPDX-License-Identifier: GPL-3.0-or-later
// A report in Chromium without a window: it loads nothing, logs nothing, its links lead somewhere, and it is
// no wider than a telephone. Without Chromium, or gnuplot, these are skipped.
#include "support/command.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>

namespace resonform::test {

namespace {

// Looks at page.html as at a window of 390 px; what it finds becomes the text of this page.
const char* const frame =
    R"(<!DOCTYPE html><meta charset="utf-8"><body><iframe id="f" width="390" height="800"
src="here/report.html" style="border:0"></iframe><pre id="found"></pre><script>
const frame = document.getElementById("f");
frame.onload = () => {
  const page = frame.contentDocument;
  const lines = ["width " + page.documentElement.scrollWidth];
  for (const e of page.querySelectorAll("body *"))
    if (e.getBoundingClientRect().right > 391 && !e.closest(".formulas") && !e.closest("svg"))
      lines.push("wide " + e.tagName + " " + e.textContent.slice(0, 40));
  for (const e of page.querySelectorAll("[src], link, script, object, embed")) lines.push("loads " + e.outerHTML);
  for (const e of page.querySelectorAll("use"))
    if (!page.getElementById(e.href.baseVal.slice(1))) lines.push("broken " + e.href.baseVal);
  for (const a of page.querySelectorAll("a[href]")) {
    const to = a.getAttribute("href");
    if (to[0] != "#") lines.push("link " + to);
    else if (!page.getElementById(to.slice(1))) lines.push("broken " + to);
  }
  lines.push("figures " + page.querySelectorAll("figure svg").length);
  lines.push("formulas " + page.querySelectorAll("math").length);
  for (const e of page.querySelectorAll("math"))
    if (e.getBoundingClientRect().height < 5) lines.push("flat " + e.textContent);
  document.getElementById("found").textContent = lines.join("\n") + "\n";
};
</script>)";

class SlowReportInBrowser : public Command {
protected:
    void SetUp() override {
        browser_ = run("command -v chromium || command -v chromium-browser || command -v google-chrome",
                       scratch_.path())
                       .out;
        if (browser_.empty()) GTEST_SKIP() << "no Chromium (Debian: chromium)";
        browser_.erase(browser_.find_last_not_of("\n") + 1);
        if (run("command -v gnuplot", scratch_.path()).out.empty()) GTEST_SKIP() << "no gnuplot";
        write_spring(scratch_.path());
        const Outcome made = said("verify systems/spring/scenes/s.toml --report here");
        ASSERT_EQ(made.code, 0) << made.err;
        write(scratch_.path() / "frame.html", frame);
    }
    [[nodiscard]] Outcome looked(const std::string& options, const std::string& page) const {
        return run(
            "timeout 120 " + browser_ +
                " --headless --no-sandbox --hide-scrollbars --disable-gpu --allow-file-access-from-files "
                "--enable-logging=stderr "
                "--user-data-dir=profile --virtual-time-budget=5000 " +
                options + " file://$PWD/" + page,
            scratch_.path());
    }
    // What frame.html has found.
    [[nodiscard]] std::string found() const {
        const std::string page = looked("--dump-dom", "frame.html").out;
        const std::string begin = "<pre id=\"found\">";
        const std::size_t at = page.find(begin);
        EXPECT_NE(at, std::string::npos) << page.substr(0, 500);
        return at == std::string::npos
                   ? ""
                   : page.substr(at + begin.size(), page.find("</pre>", at) - at - begin.size());
    }

    std::string browser_;
};

std::size_t number_after(const std::string& word, const std::string& text) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(word + " ([0-9]+)")) ? std::stoul(found[1]) : 0;
}

} // namespace

TEST_F(SlowReportInBrowser, IsNoWiderThanATelephoneLoadsAndLogsNothing) {
    const std::string seen = found();
    EXPECT_EQ(number_after("width", seen), 390U) << seen;
    EXPECT_GT(number_after("figures", seen), 4U) << seen;
    EXPECT_GT(number_after("formulas", seen), 4U) << seen;
    for (const char* wrong : {"wide ", "loads ", "broken ", "flat "})
        EXPECT_EQ(seen.find(wrong), std::string::npos) << seen;
    const std::regex link("link ([^\n]+)");
    std::size_t links = 0;
    for (std::sregex_iterator at(seen.begin(), seen.end(), link), end; at != end; ++at, ++links)
        EXPECT_TRUE(std::filesystem::exists(scratch_.path() / "here" / (*at)[1].str())) << (*at)[1];
    EXPECT_EQ(links, number_after("figures", seen));
    const std::regex console("CONSOLE[^\n]*");
    const std::string log = looked("--dump-dom", "here/report.html").err;
    std::smatch line;
    EXPECT_FALSE(std::regex_search(log, line, console)) << line.str();
}

// The same eyes see what is wrong.
TEST_F(SlowReportInBrowser, SeesAPageThatIsWideAndBroken) {
    write(scratch_.path() / "here/report.html",
          "<!DOCTYPE html><meta name=viewport content=width=device-width><p style='width:900px'>wide</p>"
          "<a href='#nowhere'>a</a><img src='none.png'>");
    const std::string seen = found();
    for (const char* wrong : {"wide P", "broken #nowhere", "loads &lt;img"})
        EXPECT_NE(seen.find(wrong), std::string::npos) << wrong << ": " << seen;
    EXPECT_GT(number_after("width", seen), 390U);
}

TEST_F(SlowReportInBrowser, LosesNothingOnPaper) {
    if (run("command -v pdftotext", scratch_.path()).out.empty())
        GTEST_SKIP() << "no pdftotext (Debian: poppler-utils)";
    (void)looked("--no-pdf-header-footer --print-to-pdf=page.pdf", "here/report.html");
    const std::string text = run("pdftotext -layout page.pdf -", scratch_.path()).out;
    for (const char* part : {"Verdict", "System and scene", "Every run", "What was left out", "Normal form"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    // Rows of what is folded on the screen.
    EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 100);
    EXPECT_NE(text.find("tolerance 10⁻¹³"), std::string::npos) << text;
}

} // namespace resonform::test
