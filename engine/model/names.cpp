// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/names.hpp"

#include <algorithm>

namespace resonform {

namespace {

constexpr std::size_t longest_name = 60;
constexpr const char* digits = "0123456789";
constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
constexpr const char* allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_";

bool is_mode(const std::string& name) {
    return name.size() > 1 && name[0] == 'z' && name.find_first_not_of(digits, 1) == std::string::npos;
}

} // namespace

bool is_identifier(const std::string& name) {
    return !name.empty() && name.size() <= longest_name &&
           std::string_view(letters).find(name[0]) != std::string_view::npos &&
           name.find_first_not_of(allowed) == std::string::npos;
}

std::string identifier_rule(const std::string& what) {
    return what + " is a letter followed by letters, digits and _, at most " + std::to_string(longest_name);
}

std::string identifier_mend() { return "choose such a name, in ASCII"; }

bool is_reserved(const std::string& name) {
    static const std::vector<std::string> words = {"I", "pi", "E", "eps", "lambda", "t"};
    const std::vector<std::string>& functions = function_names();
    return is_mode(name) || std::find(words.begin(), words.end(), name) != words.end() ||
           std::find(functions.begin(), functions.end(), name) != functions.end();
}

std::vector<std::string> constant_kinds(Role role) {
    if (role == Role::fast) return {"amplitude", "phase"};
    if (role == Role::drift) return {"constant"};
    return {};
}

} // namespace resonform
