// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/lies.hpp"

#include <fmt/format.h>

#include <string_view>

namespace resonform {

namespace {

constexpr std::string_view call = "lied(";

// The text as it is without lies.
std::string honest(std::string text) {
    for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at)) {
        int depth = 1;
        std::size_t end = at + call.size();
        for (; depth > 0; ++end) depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
        const std::size_t inner = text.find(", ", at) + 2;
        text.replace(at, end - at, text.substr(inner, end - 1 - inner));
    }
    return text;
}

} // namespace

std::string CppLies::planted(const std::string& text) {
    places_.push_back({"", honest(text)});
    return fmt::format("{}{}, {})", call, places_.size(), text);
}

void CppLies::end_function(const std::string& name) {
    for (; named_ < places_.size(); ++named_) places_[named_].function = name;
}

std::string CppLies::declaration() const {
    return fmt::format("static unsigned char lie_kinds[{}] = {{}};\n\n", places_.size() + 1);
}

} // namespace resonform
