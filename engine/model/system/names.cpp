// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/system/names.hpp"

#include "model/text/scope.hpp"

#include <algorithm>

namespace resonform {

namespace {

constexpr std::size_t longest_name = 60;
constexpr const char* digits = "0123456789";
constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
constexpr const char* allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_";

// SymPy reads the expressions of the JSON, with the names of the file as locals. That fails for the keywords
// of Python, and for names of SymPy that occur in these expressions or in SymPy's form of them.
const std::vector<std::string>& python_words() {
    static const std::vector<std::string> words = {
        "False",    "None",  "True",       "and",     "as",       "assert", "async", "await",
        "break",    "class", "continue",   "def",     "del",      "elif",   "else",  "except",
        "finally",  "for",   "from",       "global",  "if",       "import", "in",    "is",
        "nonlocal", "not",   "or",         "pass",    "raise",    "return", "try",   "while",
        "with",     "yield", "Derivative", "Integer", "Integral", "Subs"};
    return words;
}

} // namespace

bool is_mode(const std::string& name) {
    return name.size() > 1 && name[0] == 'z' && name.find_first_not_of(digits, 1) == std::string::npos;
}

bool is_identifier(const std::string& name) {
    return !name.empty() && name.size() <= longest_name &&
           std::string_view(letters).find(name[0]) != std::string_view::npos &&
           name.find_first_not_of(allowed) == std::string::npos;
}

std::string identifier_rule(const std::string& what) {
    return what + " is a letter followed by letters, digits and _, at most " + std::to_string(longest_name);
}

std::string identifier_hint() { return "choose such a name, in ASCII"; }

bool is_reserved(const std::string& name) {
    static const std::vector<std::string> words = {"I", "pi", "E", "eps", "lambda", "t"};
    const auto is_one_of = [&](const std::vector<std::string>& list) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    return is_mode(name) || is_one_of(words) || is_one_of(function_names()) || is_one_of(python_words());
}

std::vector<std::string> constant_kinds(Role role) {
    if (role == Role::fast) return {"amplitude", "phase"};
    if (role == Role::drift) return {"constant"};
    return {};
}

std::string deviation_name(const std::string& variable) { return "delta_" + variable; }

} // namespace resonform
