// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/page.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

namespace resonform::report {

namespace {

std::string row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) {
        line += ' ';
        for (const char c : escaped(cell)) line += c == '|' ? std::string("\\|") : std::string(1, c);
        line += " |";
    }
    return line + "\n";
}

struct MarkdownWriter {
    std::string text;

    void operator()(const Paragraph& paragraph) { text += escaped(paragraph.text) + "\n\n"; }

    void operator()(const Preformatted& block) {
        text += "```\n" + block.text;
        if (block.text.empty() || block.text.back() != '\n') text += '\n';
        text += "```\n\n";
    }

    void operator()(const Formulas& formulas) { (*this)(Preformatted{formulas.text}); }

    void operator()(const Statements& statements) {
        for (const Statement& s : statements.all)
            text += fmt::format("- **{}**: {}\n", escaped(s.word), escaped(s.text));
        text += '\n';
    }

    void operator()(const Facts& facts) {
        text += "| | |\n| --- | --- |\n";
        for (const auto& [name, value] : facts.all) text += row({name, value});
        text += '\n';
    }

    void operator()(const Table& table) {
        if (!table.caption.empty()) text += "**" + escaped(table.caption) + "**\n\n";
        text += row(table.header) + "|";
        for (std::size_t i = 0; i < table.header.size(); ++i) text += i == 0 ? " --- |" : " ---: |";
        text += '\n';
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
            std::string line = row(table.rows[i]);
            if (!table.links.empty()) {
                const std::string first = escaped(table.rows[i].front());
                line.replace(2, first.size(), fmt::format("[{}]({})", first, table.links[i]));
            }
            text += line;
        }
        text += '\n';
    }

    void operator()(const Gallery& gallery) {
        for (const Figure& figure : gallery.figures)
            text += fmt::format("![{0}](figures/{1}.svg)\n\n", escaped(figure.caption), figure.name);
    }
};

} // namespace

std::string to_markdown(const Page& page) {
    MarkdownWriter writer{fmt::format("# {}\n\n{}\n\n", escaped(page.title), escaped(page.subtitle))};
    for (const Section& section : page.sections) {
        writer.text += "## " + escaped(section.title) + "\n\n";
        for (const Block& block : section.blocks) std::visit(writer, block);
    }
    return writer.text;
}

} // namespace resonform::report
