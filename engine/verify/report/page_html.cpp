// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/mathml.hpp"
#include "verify/report/page.hpp"

#include <fmt/format.h>

namespace resonform::report {

namespace {

// The first word of a verdict, "" of other texts.
std::string verdict_word(const std::string& text) {
    std::string word = text.substr(0, text.find_first_of(", "));
    for (const char* known : {"pass", "fail", "undecided", "wins", "loses"})
        if (word == known) return word;
    return "";
}

std::string link_to_numbers(const Figure& figure) {
    if (figure.csv.empty()) return "";
    return fmt::format(" <a class=\"numbers\" href=\"figures/{}.csv\">CSV</a>", figure.name);
}

struct HtmlWriter {
    std::string html;

    void operator()(const Paragraph& paragraph) {
        html += fmt::format("<p>{}</p>\n", escaped(paragraph.text));
    }

    void operator()(const Preformatted& block) {
        html += fmt::format("<pre>{}</pre>\n", escaped(block.text));
    }

    void operator()(const Formulas& formulas) {
        html += "<div class=\"formulas\">\n";
        for (const FormulaLine& line : formula_lines(formulas.latex)) {
            if (line.terms.empty()) {
                html += fmt::format("<p>{}</p>\n", escaped(line.words));
                continue;
            }
            html += "<p class=\"equation\">";
            for (const std::string& term : line.terms) html += to_mathml(term) + " ";
            html += "</p>\n";
        }
        html += "</div>\n";
    }

    void operator()(const Statements& statements) {
        html += "<ul class=\"statements\">\n";
        for (const Statement& s : statements.all)
            html += fmt::format("<li><span class=\"word {}\">{}</span> <span>{}</span></li>\n",
                                verdict_word(s.word), escaped(s.word), escaped(s.text));
        html += "</ul>\n";
    }

    void operator()(const Facts& facts) {
        html += "<dl>\n";
        for (const auto& [name, value] : facts.all)
            html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(name), escaped(value));
        html += "</dl>\n";
    }

    void operator()(const Table& table) {
        if (table.folded) html += fmt::format("<details><summary>{}</summary>\n", escaped(table.caption));
        html += "<table>\n";
        if (!table.folded && !table.caption.empty())
            html += fmt::format("<caption>{}</caption>\n", escaped(table.caption));
        html += "<thead><tr>";
        for (const std::string& cell : table.header) html += fmt::format("<th>{}</th>", escaped(cell));
        html += "</tr></thead>\n<tbody>\n";
        for (std::size_t k = 0; k < table.rows.size(); ++k) {
            const std::vector<std::string>& cells = table.rows[k];
            html += "<tr>";
            for (std::size_t i = 0; i < cells.size(); ++i)
                cell(table.header[i], cells[i], i == 0 && !table.links.empty() ? table.links[k] : "");
            html += "</tr>\n";
        }
        html += "</tbody></table>\n";
        if (table.folded) html += "</details>\n";
    }

    // Where the window is narrow a row is a list, and each cell has its header beside it.
    void cell(const std::string& header, const std::string& text, const std::string& link) {
        const std::string word = verdict_word(text);
        const std::string shown =
            link.empty() ? escaped(text) : fmt::format("<a href=\"{}\">{}</a>", escaped(link), escaped(text));
        html += fmt::format("<td{}{}>{}</td>", word.empty() ? "" : fmt::format(" class=\"{}\"", word),
                            header.empty() ? "" : fmt::format(" data-header=\"{}\"", escaped(header)), shown);
    }

    void operator()(const Gallery& gallery) {
        if (gallery.figures.empty()) return;
        html += fmt::format("<div class=\"gallery{}\">\n", gallery.small ? " small" : "");
        for (const Figure& figure : gallery.figures)
            html += fmt::format("<figure>{}<figcaption>{}{}</figcaption></figure>\n", figure.svg,
                                escaped(figure.caption), link_to_numbers(figure));
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
                              escaped(page.title), page_style, escaped(page.subtitle));
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
