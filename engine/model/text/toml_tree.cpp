// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/toml_tree.hpp"

#include "algebra/number/error.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace resonform {

namespace {

constexpr std::uintmax_t largest_file = 4000000; // bytes
constexpr int deepest = 8;                       // tables in tables
constexpr int longest_dotted_key = 32;           // dots of one key

// The lines of the file, and the text at a position of the parser.
class Lines {
public:
    Lines(std::string_view text, std::string file) : file_(std::move(file)) {
        std::size_t begin = 0;
        while (begin <= text.size()) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            std::string_view line = text.substr(begin, end - begin);
            if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
            lines_.push_back(line);
            begin = end + 1;
        }
    }

    [[nodiscard]] std::string_view line(const toml::source_position& at) const {
        return at.line >= 1 && at.line <= lines_.size() ? lines_[at.line - 1] : std::string_view{};
    }

    // The parser counts characters; everything here counts bytes, from 0.
    [[nodiscard]] std::size_t byte(const toml::source_position& at) const {
        const std::string_view text = line(at);
        std::size_t byte = 0;
        for (std::size_t character = 1; character < at.column && byte < text.size(); ++character) {
            ++byte;
            while (byte < text.size() && (static_cast<unsigned char>(text[byte]) & 0xC0U) == 0x80U) ++byte;
        }
        return byte;
    }

    // And back: the character of a byte, from 1.
    [[nodiscard]] static toml::source_index character(std::string_view text, std::size_t byte) {
        const auto* const end = text.begin() + static_cast<std::ptrdiff_t>(byte);
        return static_cast<toml::source_index>(1 + std::count_if(text.begin(), end, [](char c) {
                                                   return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
                                               }));
    }

    [[nodiscard]] SourceText source(const toml::source_position& at, std::string key) const {
        SourceText source;
        source.file = file_;
        source.key = std::move(key);
        source.line = static_cast<int>(at.line);
        source.column = static_cast<int>(byte(at)) + 1;
        source.source_line = printable(line(at));
        return source;
    }

private:
    std::string file_;
    std::vector<std::string_view> lines_;
};

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

// A string's text begins behind its quotes, on the next line if they are three and the line ends.
void locate_string(TomlNode& node, const Lines& lines, const toml::source_region& region) {
    const std::string_view rest = lines.line(region.begin).substr(lines.byte(region.begin));
    const bool triple = rest.substr(0, 3) == "\"\"\"" || rest.substr(0, 3) == "'''";
    const std::size_t quotes = triple ? 3 : 1;
    if (triple && rest.size() == quotes) {
        const toml::source_position next{region.begin.line + 1, 1};
        node.source = lines.source(next, node.source.key);
    } else {
        node.source.column += static_cast<int>(quotes);
    }
    // Verbatim if the file shows the first line of the text as it is; an escape breaks that.
    const std::size_t begin = static_cast<std::size_t>(node.source.column) - 1;
    const std::string first_line = node.text.substr(0, node.text.find('\n'));
    node.source.verbatim = node.source.source_line.compare(std::min(begin, node.source.source_line.size()),
                                                           first_line.size(), first_line) == 0 &&
                           (triple || rest.find('\\') == std::string_view::npos);
}

std::string spelling(const Lines& lines, const toml::source_region& region) {
    const std::string_view rest = lines.line(region.begin).substr(lines.byte(region.begin));
    return std::string(rest.substr(0, rest.find_first_of(" \t,]}#")));
}

TomlNode::Type type_of(const toml::node& node) {
    switch (node.type()) {
    case toml::node_type::string: return TomlNode::Type::string;
    case toml::node_type::integer: return TomlNode::Type::integer;
    case toml::node_type::floating_point: return TomlNode::Type::real;
    case toml::node_type::boolean: return TomlNode::Type::boolean;
    case toml::node_type::array: return TomlNode::Type::array;
    case toml::node_type::table: return TomlNode::Type::table;
    default: return TomlNode::Type::date;
    }
}

TomlNode convert(const toml::node& node, const Lines& lines, const std::string& path, int depth);

void convert_entries(TomlNode& result, const toml::table& table, const Lines& lines, int depth) {
    const std::string& path = result.source.key;
    for (auto&& [key, value] : table) {
        TomlEntry entry;
        entry.key = std::string(key.str());
        const std::string key_path = path.empty() ? entry.key : path + "." + entry.key;
        entry.place = place_of(lines.source(key.source().begin, key_path));
        entry.value = convert(value, lines, key_path, depth + 1);
        result.entries.push_back(std::move(entry));
    }
    std::stable_sort(
        result.entries.begin(), result.entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
            return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
        });
}

TomlNode convert(const toml::node& node, const Lines& lines, const std::string& path, int depth) {
    TomlNode result;
    result.type = type_of(node);
    result.source = lines.source(node.source().begin, path);
    if (depth > deepest) {
        bad_input(Reason::syntax, {"tables and arrays nest at most " + std::to_string(deepest) + " deep",
                                   excerpt(path), "flatten the file", place_of(result.source)});
    }
    switch (result.type) {
    case TomlNode::Type::string:
        result.text = node.as_string()->get();
        locate_string(result, lines, node.source());
        break;
    case TomlNode::Type::table: convert_entries(result, *node.as_table(), lines, depth); break;
    case TomlNode::Type::array:
        for (const toml::node& item : *node.as_array()) {
            result.items.push_back(
                convert(item, lines, path + "[" + std::to_string(result.items.size()) + "]", depth + 1));
        }
        break;
    default: result.text = spelling(lines, node.source()); break;
    }
    return result;
}

// The parser nests one table per dot, and its destructor recurses through them.
void check_dotted_keys(const Lines& lines, std::string_view text) {
    std::size_t line = 1;
    int dots = 0;
    char quote = 0; // the one that is open; '#' stands for a comment
    for (char c : text) {
        if (c == '\n') {
            ++line;
            dots = 0;
            quote = 0;
        } else if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'' || c == '#') {
            quote = c;
        } else if (c == '=' || c == ',') {
            dots = 0;
        } else if (c == '.' && ++dots > longest_dotted_key) {
            const toml::source_position at{static_cast<toml::source_index>(line), 1};
            bad_input(Reason::syntax,
                      {"a key has at most " + std::to_string(longest_dotted_key) + " dots",
                       excerpt(lines.line(at)), "flatten the file", place_of(lines.source(at, ""))});
        }
    }
}

// The table that a line stands in: the words of the last [header] above it.
std::string table_above(const Lines& lines, toml::source_index line) {
    while (line > 1) {
        --line;
        std::string_view text = trimmed(lines.line({line, 1}));
        if (text.empty() || text.front() != '[') continue;
        text = text.substr(text.find_first_not_of('['));
        const std::size_t end = text.find(']');
        const bool header = end != std::string_view::npos && text.find_first_of(",\"'=") >= end;
        if (header) return std::string(trimmed(text.substr(0, end)));
    }
    return "";
}

// The parser points behind a key that is given twice, or before a table; here is its own place, and its path.
Place place_of_second(const Lines& lines, toml::source_position at, const std::string& key) {
    const std::string_view line = lines.line(at);
    const bool table = trimmed(line).substr(0, 1) == "[";
    const std::size_t found = table ? line.find(key) : line.rfind(key, lines.byte(at));
    if (found != std::string_view::npos) at.column = Lines::character(line, found);
    if (table) return place_of(lines.source(at, key));
    std::string path = table_above(lines, at.line);
    const auto go_into = [&](std::string_view part) { path.append(path.empty() ? "" : ".").append(part); };
    if (line.find('{') < lines.byte(at)) go_into(trimmed(line.substr(0, line.find('='))));
    go_into(key);
    return place_of(lines.source(at, path));
}

[[noreturn]] void not_toml(const Lines& lines, const toml::parse_error& failure) {
    const toml::source_position at = failure.source().begin;
    const std::string_view reason = failure.description();
    constexpr std::string_view twice = "cannot redefine existing";
    const std::size_t end = reason.rfind('\''), begin = reason.find('\'', std::min(reason.find(twice), end));
    if (reason.find(twice) != std::string_view::npos && begin < end)
        bad_input(Reason::syntax,
                  {"a key is given once, a table too", excerpt(lines.line(at)), "remove one of the two",
                   place_of_second(lines, at, std::string(reason.substr(begin + 1, end - begin - 1)))});
    for (const std::string_view limit :
         {"exceeds length limit", "could not be interpreted as a value", "not representable in 64 bits"})
        if (reason.find(limit) != std::string_view::npos)
            bad_input({"a number without quotes has the length and the range that TOML gives to numbers",
                       excerpt(lines.line(at)), "write it in quotes: it is taken exactly as spelled",
                       place_of(lines.source(at, ""))});
    bad_input(Reason::syntax,
              {"the file is not valid TOML", excerpt(lines.line(at)),
               "the TOML parser says: " + printable(reason.substr(0, 300)), place_of(lines.source(at, ""))});
}

} // namespace

const TomlNode* TomlNode::find(std::string_view key) const {
    for (const TomlEntry& entry : entries) {
        if (entry.key == key) return &entry.value;
    }
    return nullptr;
}

std::string read_text(const std::filesystem::path& file) {
    std::error_code ignored;
    const Place place = whole_file(file);
    const std::filesystem::file_status status = std::filesystem::status(file, ignored);
    if (!std::filesystem::exists(status)) {
        bad_input(Reason::file, {"no such file", excerpt(file.string()), "check the path", place});
    }
    if (!std::filesystem::is_regular_file(status)) {
        bad_input(Reason::file,
                  {"not a regular file", excerpt(file.string()), "give the path of a file", place});
    }
    const std::uintmax_t size = std::filesystem::file_size(file, ignored);
    if (size > largest_file) {
        bad_input(Reason::file, {"a file has at most " + std::to_string(largest_file) + " bytes",
                                 std::to_string(size) + " bytes", "shorten it", place});
    }
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (size > 0) text << stream.rdbuf();
    if (!stream || (size > 0 && !text)) {
        bad_input(Reason::file,
                  {"the file cannot be read", excerpt(file.string()), "check its permissions", place});
    }
    return text.str();
}

TomlNode read_toml(std::string_view text, const std::filesystem::path& file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // some editors begin a file with it
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
    const Lines lines(text, file.string());
    check_dotted_keys(lines, text);
    try {
        const toml::table table = toml::parse(text, file.string());
        return convert(table, lines, "", 0);
    } catch (const toml::parse_error& failure) {
        not_toml(lines, failure);
    }
}

} // namespace resonform
