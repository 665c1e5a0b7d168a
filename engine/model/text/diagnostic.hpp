// SPDX-License-Identifier: GPL-3.0-or-later
// Where a text of a user's file stands, and how a position inside it becomes the Place of a message.
#pragma once

#include "algebra/number/error.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace resonform {

// Where a text comes from, so that a column in it can be shown in the file.
struct SourceText : Place { // of its first character
    bool verbatim = true;   // false: the file spells the text with escapes, offsets do not carry over
};

// The place of the whole text.
Place place_of(const SourceText& source);

// The place of a file as a whole, for entries that are missing in it.
Place whole_file(const std::filesystem::path& file);

// The place of the byte `offset` of `text`; a text of several lines is followed to the right one.
Place place_at(const SourceText& source, std::string_view text, std::size_t offset);

// The text fit to be printed: control characters but tabs, and bytes that are not UTF-8, become '?'.
// Its length and its columns stay.
std::string printable(std::string_view text);

// text[begin, end), printable, at most 60 bytes, cut with "...".
std::string excerpt(std::string_view text, std::size_t begin = 0, std::size_t end = std::string_view::npos);

// 'text', cut like excerpt.
std::string in_quotes(std::string_view text);

} // namespace resonform
