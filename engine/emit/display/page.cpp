// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/page.hpp"

#include "emit/display/latex.hpp"
#include "emit/display/spelling.hpp"

#include <utility>

namespace resonform {

namespace {

constexpr std::size_t text_columns = 100;
constexpr std::size_t latex_terms = 4; // per line

bool starts_negative(const std::string& text) { return !text.empty() && text.front() == '-'; }

// "+ a" or "- a", to be appended to earlier terms.
std::string continued(const std::string& text) {
    return starts_negative(text) ? "- " + text.substr(1) : "+ " + text;
}

std::vector<const DisplaySum*> without_empty(const std::vector<DisplaySum>& groups) {
    std::vector<const DisplaySum*> result;
    for (const DisplaySum& group : groups)
        if (!group.terms.empty()) result.push_back(&group);
    return result;
}

// Appends a group, or its terms one by one if it is too long for a line.
void append_pieces(std::vector<std::string>& pieces, const DisplaySum& group) {
    constexpr std::size_t most = (text_columns + 3) / 4; // terms in a line: "a + b" has four columns a term
    if (std::string text = group.terms.size() > most ? "" : spell(group, text_spelling());
        !text.empty() && text.size() <= text_columns) {
        pieces.push_back(std::move(text));
        return;
    }
    for (const DisplayTerm& term : group.terms) pieces.push_back(spell(DisplaySum{{term}}, text_spelling()));
}

std::vector<std::string> text_pieces(const Side& s) {
    std::vector<std::string> pieces;
    for (const DisplaySum* group : without_empty(s.groups)) append_pieces(pieces, *group);
    if (!cln::zerop(s.remainder))
        pieces.push_back("O(" + spell(symbol_factor("eps", s.remainder), text_spelling()) + ")");
    if (pieces.empty()) pieces.emplace_back("0");
    return pieces;
}

// Pieces on one line if they fit, else each on its own, under the first.
std::string text_side(const Side& s, std::size_t column) {
    const std::vector<std::string> pieces = text_pieces(s);
    std::size_t length = column;
    for (const std::string& piece : pieces) length += piece.size() + 3;
    const std::string separator = length <= text_columns ? std::string(" ") : "\n" + std::string(column, ' ');
    std::string text = pieces.front();
    for (std::size_t i = 1; i < pieces.size(); ++i) text += separator + continued(pieces[i]);
    return text;
}

std::string text_formula(const Formula& formula, std::size_t indent) {
    const std::string left = text_side(formula.left, indent);
    const std::size_t line_start = left.rfind('\n');
    const std::size_t column =
        line_start == std::string::npos ? indent + left.size() : left.size() - line_start - 1;
    std::string text = std::string(indent, ' ') + left + " = " + text_side(formula.right, column + 3);
    for (const Formula& other : formula.together) text += " and " + text_formula(other, 0);
    return text;
}

// Groups cut into lines of at most latex_terms terms; everything on one line if it is short.
std::vector<std::string> latex_lines(const Side& s) {
    const std::vector<const DisplaySum*> groups = without_empty(s.groups);
    std::size_t terms = 0;
    for (const DisplaySum* group : groups) terms += group->terms.size();
    std::vector<DisplaySum> lines;
    for (const DisplaySum* group : groups)
        for (std::size_t i = 0; i < group->terms.size(); ++i) {
            const bool new_line = lines.empty() || (terms > latex_terms && i % latex_terms == 0);
            if (new_line) lines.emplace_back();
            lines.back().terms.push_back(group->terms[i]);
        }
    std::vector<std::string> result;
    result.reserve(lines.size());
    for (const DisplaySum& line : lines) result.push_back(latex(line));
    if (!cln::zerop(s.remainder)) {
        const std::string power = s.remainder == 1 ? "" : "^{" + to_string(s.remainder) + "}";
        const std::string order = "O\\left(\\varepsilon" + power + "\\right)";
        if (result.empty())
            result.push_back(order);
        else
            result.back() += " + " + order;
    }
    if (result.empty()) result.emplace_back("0");
    return result;
}

std::string join_lines(const std::vector<std::string>& lines) {
    std::string text = lines.front();
    for (std::size_t i = 1; i < lines.size(); ++i) text += " \\\\\n  &\\quad " + continued(lines[i]);
    return text;
}

std::string latex_formula(const Formula& formula) {
    const std::vector<std::string> left = latex_lines(formula.left);
    if (left.size() > 1) return "  &" + join_lines(left) + " = " + join_lines(latex_lines(formula.right));
    std::string text = "  " + left.front() + " &= " + join_lines(latex_lines(formula.right));
    for (const Formula& other : formula.together)
        text += " \\quad\\text{and}\\quad " + join_lines(latex_lines(other.left)) + " = " +
                join_lines(latex_lines(other.right));
    return text;
}

} // namespace

Side side(DisplaySum sum, const Rational& remainder) {
    Side result;
    result.groups.push_back(std::move(sum));
    result.remainder = remainder;
    return result;
}

Side zero_side() { return {}; }

void define(Section& section, const std::string& name, Side right) {
    section.formulas.push_back({side(symbol_sum(name)), std::move(right)});
}

void define(Section& section, const std::string& name, DisplaySum right) {
    define(section, name, side(std::move(right)));
}

void append_sections(Page& page, std::vector<Section> sections) {
    for (Section& section : sections)
        if (!section.formulas.empty()) page.sections.push_back(std::move(section));
}

std::string page_text(const Page& page) {
    std::string text = page.title + "\n";
    for (const Section& section : page.sections) {
        text += "\n";
        if (!section.heading.empty()) text += section.heading + ":\n";
        for (const Formula& formula : section.formulas)
            text += text_formula(formula, section.heading.empty() ? 0 : 2) + "\n";
    }
    if (!page.remarks.empty()) text += "\n";
    for (const std::string& remark : page.remarks) text += remark + "\n";
    return text;
}

std::string page_latex(const Page& page) {
    std::string text = "% " + page.title + "\n% needs \\usepackage{amsmath}\n";
    for (const Section& section : page.sections) {
        if (!section.heading.empty()) text += latex_text(section.heading) + ":\n";
        if (section.formulas.empty()) continue;
        text += "\\begin{align*}\n";
        for (std::size_t i = 0; i < section.formulas.size(); ++i)
            text += latex_formula(section.formulas[i]) + (i + 1 < section.formulas.size() ? " \\\\\n" : "\n");
        text += "\\end{align*}\n";
    }
    for (const std::string& remark : page.remarks) text += "% " + remark + "\n";
    return text;
}

} // namespace resonform
