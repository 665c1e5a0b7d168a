// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/mathml.hpp"

#include "verify/report/page.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstddef>
#include <map>
#include <sstream>

namespace resonform::report {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string element(const char* name, const std::string& content) {
    return fmt::format("<{0}>{1}</{0}>", name, content);
}

// Commands that stand for one sign, with the element that shows it.
const std::map<std::string, std::string>& signs_of_commands() {
    static const std::map<std::string, std::string> signs{
        {"cdot", "<mo>·</mo>"},
        {"int", "<mo largeop=\"true\">∫</mo>"},
        {"partial", "<mo>∂</mo>"},
        {"infty", "<mi>∞</mi>"},
        {"le", "<mo>≤</mo>"},
        {"ge", "<mo>≥</mo>"},
        {"to", "<mo>→</mo>"},
        {"quad", "<mspace width=\"1em\"/>"},
        {"limits", ""},
        {"_", "<mo>_</mo>"},
        {",", "<mspace width=\"0.17em\"/>"},
        {"varepsilon", "<mi>ε</mi>"},
        {"displaystyle", ""},
        {"langle", "<mo>⟨</mo>"},
        {"rangle", "<mo>⟩</mo>"},
        {"dots", "<mo>…</mo>"},
    };
    return signs;
}

// Reads from the left; every function leaves `at_` behind what it has read.
class LatexReader {
public:
    explicit LatexReader(const std::string& text) : text_(text) {}

    // Up to the end, or up to a '}' or \right of an outer group, which is not read.
    std::string row() {
        std::string out;
        for (skip_spaces(); at_ < text_.size() && text_[at_] != '}' && !stands("\\right"); skip_spaces())
            out += scripted();
        return out;
    }

private:
    void skip_spaces() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    }

    [[nodiscard]] bool stands(const std::string& word) const {
        return text_.compare(at_, word.size(), word) == 0;
    }

    std::string scripted() {
        const bool limits = stands("\\int\\limits");
        std::string base = atom();
        if (limits) at_ += std::string("\\limits").size();
        std::string below, above;
        for (skip_spaces(); at_ < text_.size() && (text_[at_] == '_' || text_[at_] == '^'); skip_spaces()) {
            std::string& script = text_[at_++] == '_' ? below : above;
            script = group();
        }
        if (below.empty() && above.empty()) return base;
        if (above.empty()) return element("msub", base + below);
        if (below.empty()) return element("msup", base + above);
        return element(limits ? "munderover" : "msubsup", base + below + above);
    }

    // "{...}", or the one sign that stands in its place.
    std::string group() {
        skip_spaces();
        if (at_ >= text_.size()) return "<mrow></mrow>";
        if (text_[at_] != '{') return atom();
        ++at_;
        const std::string inside = row();
        if (at_ < text_.size()) ++at_; // }
        return element("mrow", inside);
    }

    // The letters within braces, as they are.
    std::string verbatim() {
        skip_spaces();
        const std::size_t end = std::min(text_.find('}', at_), text_.size());
        std::string inside;
        for (std::size_t i = at_ + 1; i < end; ++i)
            if (text_[i] != '\\') inside += text_[i];
        at_ = std::min(end + 1, text_.size());
        return escaped(inside);
    }

    std::string atom() {
        const char c = text_[at_];
        if (c == '\\') return command();
        if (c == '{') return group();
        if (is_digit(c)) {
            const std::size_t begin = at_;
            while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
            return element("mn", text_.substr(begin, at_ - begin));
        }
        ++at_;
        if (is_letter(c)) return element("mi", std::string(1, c));
        if (c == '-') return "<mo>−</mo>";
        return c == '&' ? "" : element("mo", escaped(std::string(1, c)));
    }

    std::string command() {
        ++at_; // the backslash
        std::size_t end = at_;
        while (end < text_.size() && is_letter(text_[end])) ++end;
        if (end == at_ && end < text_.size()) ++end;
        const std::string name = text_.substr(at_, end - at_);
        at_ = end;
        return meaning(name);
    }

    std::string meaning(const std::string& name) {
        if (name == "frac") {
            const std::string above = group();
            return element("mfrac", above + group());
        }
        if (name == "sqrt") return element("msqrt", group());
        if (name == "left") return between_delimiters();
        if (name == "dot") return accented("˙");
        if (name == "ddot") return accented("¨");
        if (name == "overline") return accented("¯");
        if (name == "text") return element("mtext", verbatim());
        if (name == "mathrm") return "<mi mathvariant=\"normal\">" + verbatim() + "</mi>";
        if (name == "operatorname") return function(verbatim());
        if (const auto sign = signs_of_commands().find(name); sign != signs_of_commands().end())
            return sign->second;
        if (const std::string letter = pretty(name); letter != name) return element("mi", letter);
        if (is_letter(name.empty() ? ' ' : name[0])) return function(name);
        return element("mtext", "\\" + escaped(name));
    }

    static std::string function(const std::string& name) {
        return "<mi>" + name + "</mi><mspace width=\"0.17em\"/>";
    }

    std::string accented(const char* accent) {
        const std::string base = group();
        if (std::string(accent) == "¯")
            return "<mover accent=\"true\">" + base + "<mo stretchy=\"true\">¯</mo></mover>";
        return fmt::format("<mover>{}<mo stretchy=\"false\" class=\"dots\">{}</mo></mover>", base, accent);
    }

    std::string between_delimiters() {
        const auto delimiter = [&] {
            skip_spaces();
            if (at_ >= text_.size()) return std::string();
            if (text_[at_] == '\\') return command();
            const std::string sign = text_[at_] == '.' ? "" : escaped(std::string(1, text_[at_]));
            ++at_;
            return sign.empty() ? sign : "<mo stretchy=\"true\">" + sign + "</mo>";
        };
        const std::string left = delimiter(), inside = row();
        if (stands("\\right")) at_ += std::string("\\right").size();
        return element("mrow", left + inside + delimiter());
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

// Pieces of "x &= a + b - c", each but the first with the sign before it.
std::vector<std::string> pieces_of(const std::string& row) {
    std::vector<std::string> pieces(1);
    int depth = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const char c = row[i];
        if (c == '{') ++depth;
        if (c == '}') --depth;
        if (row.compare(i, 5, "\\left") == 0) ++depth;
        if (row.compare(i, 6, "\\right") == 0) --depth;
        const bool sign = depth == 0 && i > 0 && row[i - 1] == ' ' && i + 1 < row.size() &&
                          row[i + 1] == ' ' && (c == '+' || c == '-');
        if (sign) pieces.emplace_back();
        pieces.back() += c;
        if (depth == 0 && c == '=') pieces.emplace_back();
    }
    std::vector<std::string> filled;
    for (const std::string& piece : pieces)
        if (piece.find_first_not_of(' ') != std::string::npos) filled.push_back(piece);
    return filled;
}

// Without "&", "\quad" at the beginning, and "\\" at the end.
std::string bare(std::string row) {
    if (const std::size_t end = row.rfind("\\\\"); end != std::string::npos && end + 2 == row.size())
        row.erase(end);
    for (std::size_t at = 0; (at = row.find('&', at)) != std::string::npos;) row.erase(at, 1);
    const std::size_t first = row.find_first_not_of(' ');
    row.erase(0, first == std::string::npos ? row.size() : first);
    if (row.compare(0, 5, "\\quad") == 0) row.erase(0, 5);
    return row;
}

} // namespace

std::string to_mathml(const std::string& latex) {
    std::string row = LatexReader(latex).row();
    // A sign that begins a piece stands between this and the piece before.
    for (const std::string sign : {"<mo>+", "<mo>−"})
        if (latex.size() > 1 && latex[1] == ' ' && row.compare(0, sign.size(), sign) == 0)
            row.replace(0, 4, "<mo form=\"infix\">");
    return "<math displaystyle=\"true\">" + row + "</math>";
}

std::vector<FormulaLine> formula_lines(const std::string& document) {
    std::vector<FormulaLine> lines;
    std::istringstream in(document);
    bool aligned = false;
    for (std::string text; std::getline(in, text);) {
        if (text.empty() || text[0] == '%') continue;
        if (text.compare(0, 6, "\\begin") == 0 || text.compare(0, 4, "\\end") == 0) {
            aligned = text[1] == 'b';
        } else if (!aligned) {
            lines.push_back({text, {}});
        } else {
            const std::size_t mark = text.find('&');
            const bool continued = mark != std::string::npos && text.find_first_not_of(' ') == mark;
            if (!continued || lines.empty()) lines.emplace_back();
            for (std::string& piece : pieces_of(bare(text))) lines.back().terms.push_back(std::move(piece));
        }
    }
    return lines;
}

} // namespace resonform::report
