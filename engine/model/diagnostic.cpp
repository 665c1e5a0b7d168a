// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/diagnostic.hpp"

#include <algorithm>

namespace resonform {

namespace {

bool continues_utf8(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

} // namespace

Place place_of(const SourceText& source) {
    Place place;
    place.file = source.file;
    place.line = source.line;
    place.column = source.column;
    place.key = source.key;
    place.source_line = source.source_line;
    return place;
}

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
    place.source_line = std::string(text.substr(start, end - start));
    return place;
}

std::string excerpt(std::string_view text, std::size_t begin, std::size_t end) {
    constexpr std::size_t longest = 60;
    begin = std::min(begin, text.size());
    end = std::min(std::max(end, begin), text.size());
    std::string shown(text.substr(begin, std::min(end - begin, longest)));
    if (end - begin > longest) {
        while (!shown.empty() && continues_utf8(shown.back())) shown.pop_back();
        if (!shown.empty() && static_cast<unsigned char>(shown.back()) >= 0xC0U) shown.pop_back();
        shown += "...";
    }
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) < 0x20U || c == '\x7f') c = '?';
    }
    return shown;
}

std::string in_quotes(std::string_view text) { return "'" + excerpt(text) + "'"; }

} // namespace resonform
