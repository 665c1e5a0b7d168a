// SPDX-License-Identifier: GPL-3.0-or-later
// Whole numbers as digits of text that emitted code reads (runtime/digits.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace resonform {

constexpr std::size_t digit_base = 90;

char digit(std::size_t n);
// Of n < 90^count, the highest first.
std::vector<std::size_t> digits_of(std::size_t n, std::size_t count);
std::string in_digits(std::size_t n, std::size_t count);

// A text as C++ literals, one a line.
std::string literal_lines(const std::string& text);

} // namespace resonform
