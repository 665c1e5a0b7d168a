// SPDX-License-Identifier: GPL-3.0-or-later
// A page of results: its content, independent of HTML or Markdown.
#pragma once

#include "algebra/number/number.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace resonform::report {

struct Paragraph {
    std::string text;
};

struct Preformatted {
    std::string text;
};

// Equations: of the same content, LaTeX (as emit/display writes it) for HTML, text for Markdown.
struct Formulas {
    std::string latex, text;
};

// What is said in a word and told in a sentence: "pass": "x is third order on t <= 1/eps".
struct Statement {
    std::string word; // "pass", "fail", "undecided", "wins", "loses" are coloured
    std::string text;
};
struct Statements {
    std::vector<Statement> all;
};

// Names and values, such as the parameters of a scene.
struct Facts {
    std::vector<std::pair<std::string, std::string>> all;
};

struct Table {
    std::string caption;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>>
        rows;            // a cell "pass", "fail", "undecided", with or without ", ...", is coloured
    bool folded = false; // long: HTML shows it on demand
    std::vector<std::string> links = {}; // where the first cell of each row leads to, or none at all
};

struct Figure {
    std::string name; // of its files: figures/<name>.svg, figures/<name>.csv
    std::string svg;
    std::string caption;
    std::string csv = {}; // its numbers
};

// Figures side by side as far as the window allows.
struct Gallery {
    std::vector<Figure> figures;
    bool small = false; // of small plots
};

using Block = std::variant<Paragraph, Preformatted, Formulas, Statements, Facts, Table, Gallery>;

struct Section {
    std::string title;
    std::vector<Block> blocks;
};

struct Page {
    std::string title, subtitle;
    std::vector<Section> sections;
};

// One self-contained page: its style inside, figures inline, no script, nothing loaded. The numbers of the
// figures are linked as figures/<name>.csv.
std::string to_html(const Page& page);
// The same for documents; figures are referred to as figures/<name>.svg.
std::string to_markdown(const Page& page);

// The style sheet of to_html(): light and dark, from 390 px on, and for paper.
extern const char* const page_style;

// 0.00253 -> "2.53·10⁻³", 12.5 -> "12.5".
std::string short_number(double value, int significant_digits = 3);

// 0.001 -> "0.001", 2e-05 -> "2·10⁻⁵": of values that were given.
std::string plain_number(double value);

// A text that HTML takes as text, inside of Markdown too.
std::string escaped(const std::string& text);

// A name as it is read: "psi'" -> "ψ'", "C_delta" -> "C_δ", "x" -> "x".
std::string pretty(const std::string& name);

// "ε", "ε⁴", "ε^(7/2)": a power of eps in a page.
std::string power_of_eps(const Rational& exponent);

// A text of the terminal as it is printed: "slope 3 on t <= 1/eps^2, psi -> 0" -> "slope 3 on t ≤ 1/ε², ψ →
// 0".
std::string typeset(const std::string& text);

} // namespace resonform::report
