// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/compact_svg.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

namespace resonform {

namespace {

void erase_all(std::string& text, const std::string& begin, const std::string& end) {
    for (std::size_t from = 0; (from = text.find(begin, from)) != std::string::npos;) {
        const std::size_t to = text.find(end, from);
        if (to == std::string::npos) return;
        text.erase(from, to + end.size() - from);
    }
}

// <use .../> with this in it.
void erase_marks_with(std::string& text, const std::string& part) {
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos;) {
        const std::size_t begin = text.rfind('<', at), end = text.find("/>", at);
        if (end == std::string::npos) return;
        text.erase(begin, end + 2 - begin);
        at = begin;
    }
}

// gnuplot defines marks and filters whether or not a plot has them: three quarters of a small one.
std::string without_unused(std::string svg) {
    erase_all(svg, "\t<filter", "</filter>\n");
    erase_marks_with(svg, "scale(0.00)");
    for (bool found = true; found;) { // a mark may be made of another
        found = false;
        for (std::size_t at = 0; (at = svg.find(" id='", at)) != std::string::npos; ++at) {
            const std::size_t begin = at + 5, end = svg.find('\'', begin);
            if (svg.find("'#" + svg.substr(begin, end - begin) + "'") != std::string::npos) continue;
            const std::size_t line = svg.rfind('\n', at) + 1;
            svg.erase(line, svg.find('\n', at) + 1 - line);
            found = true;
            at = line;
        }
    }
    return svg;
}

void erase_empty_groups(std::string& svg) {
    for (std::size_t at = 0; (at = svg.find(">\n</g>\n", at)) != std::string::npos;) {
        const std::size_t begin = svg.rfind('<', at);
        const bool group = svg.compare(begin, 2, "<g") == 0;
        if (group) svg.erase(begin, at + 7 - begin);
        at = group ? begin : at + 1;
    }
}

// "rgb( 46, 125,  79)" -> "#2e7d4f"
void shorten_colours(std::string& svg) {
    for (std::size_t at = 0; (at = svg.find("rgb(", at)) != std::string::npos; ++at) {
        std::array<unsigned, 3> c{};
        int length = 0;
        if (std::sscanf(svg.c_str() + at, "rgb( %u , %u , %u )%n", &c[0], &c[1], &c[2], &length) == 3 &&
            length > 0)
            svg.replace(at, static_cast<std::size_t>(length),
                        fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]));
    }
}

// What gnuplot repeats in every group, and the root says once; and blanks.
constexpr std::array<std::array<const char*, 2>, 12> shorter{{
    {" stroke-linecap=\"butt\" stroke-linejoin=\"miter\"", ""},
    {" font-family=\"Helvetica,Arial,sans-serif\"", ""},
    {" font-family=\"Helvetica\"", ""},
    {"<g fill=\"none\" color=\"black\" stroke=\"currentColor\"", "<g stroke=\"currentColor\""},
    {"<g fill=\"none\" color=\"black\"", "<g"},
    {" stroke-width=\"1.00\"", ""},
    {" class=\"gridline\"", ""},
    {".00,", ","},
    {".00 ", " "},
    {"\t", ""},
    {"<text></text>\n", ""},
    {" >", ">"},
}};

} // namespace

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

std::string compact_svg(std::string svg) {
    svg = without_unused(std::move(svg));
    erase_all(svg, "<title>", "</title>"); // the names of curves, shown at the pointer: "ladder_x_plot_1"
    shorten_colours(svg);
    for (const auto& [from, to] : shorter) replace_all(svg, from, to);
    while (svg.find("\n\n") != std::string::npos) replace_all(svg, "\n\n", "\n");
    while (svg.find("  ") != std::string::npos) replace_all(svg, "  ", " ");
    erase_empty_groups(svg);
    replace_all(svg, "<svg", "<svg fill=\"none\" color=\"black\" font-family=\"Helvetica,Arial,sans-serif\"");
    return svg;
}

} // namespace resonform
