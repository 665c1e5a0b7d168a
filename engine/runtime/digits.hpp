// SPDX-License-Identifier: MIT
// Whole numbers in text: digits of base 90, the printable characters from '#' without '?' and '\'.
#ifndef RESONFORM_RUNTIME_DIGITS
#define RESONFORM_RUNTIME_DIGITS

#include <array>

namespace resonform {

inline constexpr std::array<unsigned char, 256> digit_values = [] {
    std::array<unsigned char, 256> list{};
    unsigned char n = 0;
    for (unsigned char c = '#'; c < 0x7f; ++c)
        if (c != '?' && c != '\\') list[c] = n++;
    return list;
}();

// The number that `count` digits say; `at` goes behind them.
constexpr long long read_digits(const char*& at, int count) {
    long long n = 0;
    for (int k = 0; k < count; ++k) n = 90 * n + digit_values[static_cast<unsigned char>(*at++)];
    return n;
}

} // namespace resonform

#endif
