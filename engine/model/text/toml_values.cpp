// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/toml_values.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

std::string describe(const TomlNode& node) {
    switch (node.type) {
    case TomlNode::Type::string: return "\"" + excerpt(node.text) + "\"";
    case TomlNode::Type::array: return node.items.empty() ? "an empty array" : "an array";
    case TomlNode::Type::table: return "a table";
    default: return excerpt(node.text);
    }
}

// A spelled TOML number as the expression reader takes it: no underscores, no leading plus.
// Hexadecimal and its kin, nan and inf are none of ours.
std::optional<std::string> plain_number(const std::string& spelled) {
    std::string plain;
    for (char c : spelled) {
        if (c != '_') plain += c;
    }
    if (!plain.empty() && plain.front() == '+') plain.erase(0, 1);
    if (plain.find_first_not_of("0123456789.eE+-") != std::string::npos) return std::nullopt;
    return plain;
}

bool is_number(const TomlNode& node) {
    return node.type == TomlNode::Type::integer || node.type == TomlNode::Type::real;
}

} // namespace

void bad_value(const TomlNode& node, const std::string& rule, const std::string& hint) {
    bad_input({rule, describe(node), hint, place_of(node.source)});
}

void check_table(const TomlNode& node) {
    if (node.type == TomlNode::Type::table) return;
    const bool inner = node.source.key.find('.') != std::string::npos;
    bad_value(node, "'" + node.source.key + "' is a table",
              inner ? "write it as { key = value, ... }" : "write [" + node.source.key + "]");
}

void check_keys(const TomlNode& table, const std::vector<std::string>& known) {
    check_table(table);
    for (const TomlEntry& entry : table.entries) {
        if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
        bad_input(Reason::name,
                  {"a key is one of the known ones", entry.key.empty() ? "\"\"" : excerpt(entry.key),
                   suggest(entry.key, known), entry.place});
    }
}

std::string string_of(const TomlNode& node) {
    if (node.type != TomlNode::Type::string) {
        bad_value(node, "'" + node.source.key + "' is a string", "write it in quotes");
    }
    return node.text;
}

std::string line_of(const TomlNode& node) {
    std::string text = string_of(node);
    for (char& c : text)
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    return printable(text);
}

bool boolean_of(const TomlNode& node) {
    if (node.type != TomlNode::Type::boolean) {
        bad_value(node, "'" + node.source.key + "' is true or false", "write true or false, without quotes");
    }
    return node.text == "true";
}

int integer_of(const TomlNode& node, int lowest, int highest) {
    const std::string range = std::to_string(lowest) + " ... " + std::to_string(highest);
    const std::string rule = "'" + node.source.key + "' is an integer in " + range;
    const std::optional<std::string> plain = plain_number(node.text);
    if (node.type != TomlNode::Type::integer || !plain) bad_value(node, rule, "write an integer in " + range);
    const Rational value = number_of(node);
    if (value < lowest || value > highest) bad_value(node, rule, "write an integer in " + range);
    return cln::cl_I_to_int(cln::numerator(value));
}

Rational number_of(const TomlNode& node) {
    const GiNaC::ex value = expression_of(node, Scope{});
    if (!GiNaC::is_a<GiNaC::numeric>(value)) {
        bad_value(node, "'" + node.source.key + "' is a rational number",
                  "write a number such as 0.25 or \"1/3\"");
    }
    return cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N());
}

GiNaC::ex expression_of(const TomlNode& node, const Scope& scope) {
    if (node.type == TomlNode::Type::string) return read_expression(node.text, scope, node.source);
    if (!is_number(node)) {
        bad_value(node, "'" + node.source.key + "' is a number or an expression in quotes",
                  "write a number such as 0.25, or an expression such as \"1/3\"");
    }
    const std::optional<std::string> plain = plain_number(node.text);
    if (!plain) {
        bad_value(node, "'" + node.source.key + "' is a finite decimal number",
                  "write a number such as 0.25");
    }
    return read_expression(*plain, Scope{}, node.source);
}

} // namespace resonform
