// SPDX-License-Identifier: GPL-3.0-or-later
// The SVG of gnuplot with less text: a small figure becomes a quarter of its size.
#pragma once

#include <string>

namespace resonform {

// Marks and filters that are not used, marks of size 0, empty groups and attributes that say what holds
// anyway are taken out; what all texts and lines share moves to the root. It looks the same.
std::string compact_svg(std::string svg);

// Replaces each occurrence of `from`. Text that was put in is not searched again.
void replace_all(std::string& text, const std::string& from, const std::string& to);

} // namespace resonform
