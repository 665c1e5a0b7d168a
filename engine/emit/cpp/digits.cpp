// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/digits.hpp"

#include <fmt/format.h>

namespace resonform {

char digit(std::size_t n) {
    std::size_t c = '#' + n;
    if (c >= '?') ++c;
    if (c >= '\\') ++c;
    return static_cast<char>(c);
}

std::vector<std::size_t> digits_of(std::size_t n, std::size_t count) {
    std::vector<std::size_t> digits(count);
    for (auto d = digits.rbegin(); d != digits.rend(); ++d, n /= digit_base) *d = n % digit_base;
    return digits;
}

std::string in_digits(std::size_t n, std::size_t count) {
    std::string text;
    for (const std::size_t d : digits_of(n, count)) text += digit(d);
    return text;
}

std::string literal_lines(const std::string& text) {
    constexpr std::size_t longest = 240;
    std::string lines;
    for (std::size_t k = 0; k < text.size(); k += longest)
        lines += fmt::format("{}\"{}\"", k == 0 ? "" : "\n", text.substr(k, longest));
    return lines;
}

} // namespace resonform
