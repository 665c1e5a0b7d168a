// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/diagnostic.hpp"

#include <algorithm>

namespace resonform {

namespace {

// The length of the UTF-8 character at the beginning of a text; 0 if there is none.
std::size_t character_length(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    std::size_t length = 0;
    if (lead < 0x80U) length = 1;
    if (lead >= 0xC2U && lead < 0xE0U) length = 2;
    if (lead >= 0xE0U && lead < 0xF0U) length = 3;
    if (lead >= 0xF0U && lead < 0xF5U) length = 4;
    if (length == 0 || length > text.size()) return 0;
    const bool whole = std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length),
                                   [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; });
    return whole ? length : 0;
}

} // namespace

namespace {

// A character of two or three bytes that turns the direction of what follows, breaks lines or controls the
// terminal.
bool is_control(std::string_view character) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(character[k]); };
    if (character.size() == 2) return (byte(0) == 0xC2U && byte(1) < 0xA0U) || character == "\xD8\x9C";
    if (character.size() != 3 || byte(0) != 0xE2U) return false;
    if (byte(1) == 0x81U) return byte(2) >= 0xA0U && byte(2) <= 0xAFU;    // U+2060 ... U+206F
    return byte(1) == 0x80U && ((byte(2) >= 0x8BU && byte(2) <= 0x8FU) || // U+200B ... U+200F
                                (byte(2) >= 0xA8U && byte(2) <= 0xAEU));  // U+2028 ... U+202E
}

} // namespace

std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = character_length(text.substr(at));
        if (is_control(text.substr(at, length))) {
            shown.append(length, '?');
            at += length;
            continue;
        }
        const bool control =
            length == 1 && (static_cast<unsigned char>(text[at]) < 0x20U || text[at] == 0x7f);
        if (length == 0 || (control && text[at] != '\t')) {
            shown += '?';
            ++at;
            continue;
        }
        shown += text.substr(at, length);
        at += length;
    }
    return shown;
}

Place place_of(const SourceText& source) { return static_cast<const Place&>(source); }

Place whole_file(const std::filesystem::path& file) {
    Place place;
    place.file = file.string();
    return place;
}

Place place_at(const SourceText& source, std::string_view text, std::size_t offset) {
    Place place = place_of(source);
    if (!source.verbatim) return place;
    offset = std::min(offset, text.size());
    const std::string_view before = text.substr(0, offset);
    const std::size_t newline = before.rfind('\n');
    if (newline == std::string_view::npos) {
        place.column += static_cast<int>(offset);
        return place;
    }
    const std::size_t start = newline + 1;
    const std::size_t end = std::min(text.find('\n', start), text.size());
    place.line += static_cast<int>(std::count(before.begin(), before.end(), '\n'));
    place.column = static_cast<int>(offset - start) + 1;
    place.source_line = printable(text.substr(start, end - start));
    return place;
}

std::string excerpt(std::string_view text, std::size_t begin, std::size_t end) {
    constexpr std::size_t longest = 60;
    begin = std::min(begin, text.size());
    end = std::min(std::max(end, begin), text.size());
    std::size_t cut = end;
    if (end - begin > longest) {
        cut = begin + longest;
        while (cut > begin && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) --cut;
    }
    return printable(text.substr(begin, cut - begin)) + (cut < end ? "..." : "");
}

std::string in_quotes(std::string_view text) { return "'" + excerpt(text) + "'"; }

} // namespace resonform
