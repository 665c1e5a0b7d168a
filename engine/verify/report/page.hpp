// SPDX-License-Identifier: GPL-3.0-or-later
// A page of results: its content, independent of HTML or Markdown.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace resonform::report {

struct Paragraph {
    std::string text;
};

struct Preformatted {
    std::string text;
};

struct Table {
    std::string caption;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>>
        rows;            // a cell "pass", "fail", "undecided", with or without ", ...", is coloured
    bool folded = false; // long: HTML shows it on demand
};

struct Figure {
    std::string name; // of its file: figures/<name>.svg
    std::string svg;
    std::string caption;
};

// Figures side by side as far as the window allows.
struct Gallery {
    std::vector<Figure> figures;
};

using Block = std::variant<Paragraph, Preformatted, Table, Gallery>;

struct Section {
    std::string title;
    std::vector<Block> blocks;
};

struct Page {
    std::string title, subtitle;
    std::vector<Section> sections;
};

// One self-contained page: its style inside, figures inline, no script, nothing loaded.
std::string to_html(const Page& page);
// The same for documents; figures are referred to as figures/<name>.svg.
std::string to_markdown(const Page& page);

// 0.00253 -> "2.53·10⁻³", 12.5 -> "12.5"; three significant digits.
std::string short_number(double value);

// A text that HTML takes as text, inside of Markdown too.
std::string escaped(const std::string& text);

// A name as it is read: "psi'" -> "ψ'", "xi_0" -> "ξ_0", "x" -> "x".
std::string pretty(const std::string& name);

} // namespace resonform::report
