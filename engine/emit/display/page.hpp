// SPDX-License-Identifier: GPL-3.0-or-later
// A document before it is spelled: sections of formulas. Text and LaTeX render the same page.
#pragma once

#include "emit/display/display.hpp"

#include <string>
#include <vector>

namespace resonform {

// One side of a formula: summands in groups (a weight, a power of eps each), where lines may break, and
// the order of the neglected terms, + O(eps^remainder); 0: none are neglected.
struct Side {
    std::vector<DisplaySum> groups;
    Rational remainder = 0;
};

struct Formula {
    Side left, right;                   // left = right
    std::vector<Formula> together = {}; // short ones that hold with it, on the same line
};

struct Section {
    std::string heading; // plain text; empty: none
    std::vector<Formula> formulas;
};

struct Page {
    std::string title; // plain text
    std::vector<Section> sections;
    std::vector<std::string> remarks; // plain text, at the end
};

Side side(DisplaySum sum, const Rational& remainder = 0); // one group
Side zero_side();

// name = right
void define(Section& section, const std::string& name, Side right);
void define(Section& section, const std::string& name, DisplaySum right);
// The sections that have formulas.
void append_sections(Page& page, std::vector<Section> sections);

std::string page_text(const Page& page);  // lines of about 100 columns, broken between groups
std::string page_latex(const Page& page); // a fragment for amsmath: align* per section

} // namespace resonform
