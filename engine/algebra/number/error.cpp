// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/error.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace resonform {
namespace {

constexpr std::size_t longest_message = 2000;
constexpr std::size_t longest_field = 400;
constexpr std::size_t shown_line = 100; // bytes of the source line around the caret

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// A position at or before `at` where no UTF-8 sequence is cut.
std::size_t whole(std::string_view text, std::size_t at) {
    at = std::min(at, text.size());
    while (at > 0 && at < text.size() && is_continuation(text[at])) --at;
    return at;
}

// User text may hold control characters; a message is for a terminal.
std::string printable(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7F) c = ' ';
    }
    return out;
}

std::string location(const Place& place) {
    std::string out = shown(place.file);
    if (place.line > 0) {
        out += (out.empty() ? "line " : ":") + std::to_string(place.line);
        if (place.column > 0) out += ":" + std::to_string(place.column);
    }
    if (!place.key.empty()) out += (out.empty() ? "" : ": ") + shown(place.key);
    return out;
}

// The source line, cut to a window around the column, with a caret under it. The caret counts
// characters, not bytes.
std::string marked_line(const Place& place) {
    const std::string_view line = place.source_line;
    const std::size_t caret = place.column > 0 ? static_cast<std::size_t>(place.column) - 1 : 0;
    std::size_t begin = 0;
    if (line.size() > shown_line && caret > shown_line / 2) begin = whole(line, caret - shown_line / 2);
    const std::size_t end = whole(line, begin + shown_line);
    std::string out = "\n    " + std::string(begin > 0 ? "... " : "");
    out += printable(line.substr(begin, end - begin)) + (end < line.size() ? " ..." : "");
    if (place.column <= 0 || caret < begin || caret > end) return out;
    const auto before = std::count_if(line.begin() + static_cast<std::ptrdiff_t>(begin),
                                      line.begin() + static_cast<std::ptrdiff_t>(caret),
                                      [](char c) { return !is_continuation(c); });
    out += "\n    " + std::string(static_cast<std::size_t>(before) + (begin > 0 ? 4 : 0), ' ') + "^";
    return out;
}

} // namespace

std::string shown(std::string_view text) {
    if (text.size() <= longest_field) return printable(text);
    return printable(text.substr(0, whole(text, longest_field))) + " ...";
}

const char* to_string(Reason reason, ErrorKind kind) {
    switch (reason) {
    case Reason::by_kind: break;
    case Reason::command_line: return "command_line";
    case Reason::file: return "file";
    case Reason::syntax: return "syntax";
    case Reason::name: return "name";
    case Reason::undecided: return "undecided";
    case Reason::eigenvalues: return "eigenvalues";
    case Reason::not_semisimple: return "not_semisimple";
    case Reason::nonlinear_layer: return "nonlinear_layer";
    case Reason::resonance: return "resonance";
    case Reason::too_fast: return "too_fast";
    case Reason::not_smooth: return "not_smooth";
    case Reason::singular: return "singular";
    case Reason::size: return "size";
    case Reason::time: return "time";
    case Reason::memory: return "memory";
    case Reason::terms: return "terms";
    case Reason::integration: return "integration";
    case Reason::compiler: return "compiler";
    case Reason::fault: return "fault";
    }
    switch (kind) {
    case ErrorKind::check_failed: return "certificate";
    case ErrorKind::bad_input: return "value";
    case ErrorKind::refused: break;
    }
    return "unsupported";
}

std::string to_string(const Diagnostic& diagnostic) {
    std::string out = location(diagnostic.place);
    if (!out.empty()) out += ": ";
    out += shown(diagnostic.rule);
    if (!diagnostic.place.source_line.empty()) out += marked_line(diagnostic.place);
    if (!diagnostic.value.empty()) out += "\n  found: " + shown(diagnostic.value);
    if (!diagnostic.hint.empty()) out += "\n  hint:  " + shown(diagnostic.hint);
    if (out.size() > longest_message) out = out.substr(0, whole(out, longest_message - 4)) + " ...";
    return out;
}

} // namespace resonform
