// SPDX-License-Identifier: GPL-3.0-or-later
// A TOML file as a tree that keeps what a TOML parser forgets: the order of the keys, where each
// value stands, and how a number is spelled (0.1 is one tenth, not a double).
#pragma once

#include "algebra/number/number.hpp"
#include "model/text/diagnostic.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace resonform {

struct TomlEntry;

struct TomlNode {
    enum class Type { string, integer, real, boolean, date, array, table };

    Type type = Type::table;
    std::string text;               // string: its value; number or boolean: its spelling in the file
    std::vector<TomlEntry> entries; // table: in the order of the file
    std::vector<TomlNode> items;    // array
    SourceText source;              // of the text; source.key is the path, "variables.psi.role"

    // The entry of a table, or nullptr.
    [[nodiscard]] const TomlNode* find(std::string_view key) const;
};

struct TomlEntry {
    std::string key;
    Place place; // of the key
    TomlNode value;
};

// The text of a regular file of at most 4 MB. Errors: missing, a folder, unreadable, too large.
std::string read_text(const std::filesystem::path& file);

// Errors: not TOML (with the parser's reason), nested deeper than 8.
TomlNode read_toml(std::string_view text, const std::filesystem::path& file);

} // namespace resonform
