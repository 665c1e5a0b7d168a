// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/page.hpp"

#include <fmt/format.h>

namespace resonform::report {

namespace {

const char* const style = R"(
:root { color-scheme: light; --ink: #22262b; --soft: #5a6068; --line: #e1e4e8; --blue: #1f5fa8; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 72rem; color: var(--ink); background: #fff;
       font: 16px/1.55 system-ui, "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .25rem; }
.subtitle { color: var(--soft); margin: 0 0 1.5rem; }
nav { border-block: 1px solid var(--line); padding: .6rem 0; margin-bottom: 2rem; }
nav a { color: var(--blue); text-decoration: none; margin-right: 1.4rem; white-space: nowrap; }
h2 { font-size: 1.3rem; margin: 2.6rem 0 .8rem; padding-top: .4rem; border-top: 2px solid var(--line); }
p { max-width: 46rem; }
pre { background: #f6f7f9; border: 1px solid var(--line); border-radius: 6px; padding: .9rem 1rem;
      overflow-x: auto; font: 13px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
.gallery { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(28rem, 100%), 1fr)); gap: 1.5rem; }
figure { margin: 0; }
figure svg { display: block; width: 100%; height: auto; }
figcaption { color: var(--soft); font-size: .9rem; padding: .2rem .2rem 0; }
.scroll { overflow-x: auto; margin: 1rem 0 1.6rem; }
table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; }
th, td { text-align: right; padding: .3rem .9rem .3rem 0; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; }
th { color: var(--soft); font-weight: 600; }
.pass, .fail, .undecided { font-weight: 700; }
.pass { color: #2e7d4f; } .fail { color: #c0392b; } .undecided { color: #b06f00; }
summary { font-weight: 600; font-size: .92rem; cursor: pointer; color: var(--blue); }
@media print { nav { display: none; } }
)";

struct HtmlWriter {
    std::string html;

    void operator()(const Paragraph& paragraph) {
        html += fmt::format("<p>{}</p>\n", escaped(paragraph.text));
    }

    void operator()(const Preformatted& block) {
        html += fmt::format("<pre>{}</pre>\n", escaped(block.text));
    }

    void operator()(const Table& table) {
        if (table.folded) html += fmt::format("<details><summary>{}</summary>\n", escaped(table.caption));
        html += "<div class=\"scroll\"><table>\n";
        if (!table.folded && !table.caption.empty())
            html += fmt::format("<caption>{}</caption>\n", escaped(table.caption));
        html += "<thead><tr>";
        for (const std::string& cell : table.header) html += fmt::format("<th>{}</th>", escaped(cell));
        html += "</tr></thead>\n<tbody>\n";
        for (const auto& row : table.rows) {
            html += "<tr>";
            for (const std::string& cell : row) {
                const std::string word = cell.substr(0, cell.find(','));
                const bool verdict = word == "pass" || word == "fail" || word == "undecided";
                html += fmt::format("<td{}>{}</td>", verdict ? " class=\"" + word + "\"" : "", escaped(cell));
            }
            html += "</tr>\n";
        }
        html += "</tbody></table></div>\n";
        if (table.folded) html += "</details>\n";
    }

    void operator()(const Gallery& gallery) {
        if (gallery.figures.empty()) return;
        html += "<div class=\"gallery\">\n";
        for (const Figure& figure : gallery.figures)
            html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", figure.svg,
                                escaped(figure.caption));
        html += "</div>\n";
    }
};

} // namespace

std::string to_html(const Page& page) {
    HtmlWriter writer;
    writer.html = fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                              "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                              "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n"
                              "<p class=\"subtitle\">{2}</p>\n<nav>",
                              escaped(page.title), style, escaped(page.subtitle));
    for (std::size_t i = 0; i < page.sections.size(); ++i)
        writer.html += fmt::format("<a href=\"#s{}\">{}</a> ", i + 1, escaped(page.sections[i].title));
    writer.html += "</nav>\n";
    for (std::size_t i = 0; i < page.sections.size(); ++i) {
        writer.html +=
            fmt::format("<section id=\"s{}\">\n<h2>{}</h2>\n", i + 1, escaped(page.sections[i].title));
        for (const Block& block : page.sections[i].blocks) std::visit(writer, block);
        writer.html += "</section>\n";
    }
    return writer.html + "</body>\n</html>\n";
}

} // namespace resonform::report
