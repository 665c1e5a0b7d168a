// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace resonform::report {

namespace {

std::string superscript(int number) {
    static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string result = number < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(number))) result += digits[c - '0'];
    return result;
}

} // namespace

std::string short_number(double value) {
    if (!std::isfinite(value)) return "–";
    if (value == 0) return "0";
    if (std::abs(value) >= 0.01 && std::abs(value) < 1000) return fmt::format("{:.3g}", value);
    const std::string text = fmt::format("{:.2e}", value); // "2.53e-03"
    const std::size_t e = text.find('e');
    const int exponent = std::atoi(text.c_str() + e + 1);
    return text.substr(0, e) + "·10" + superscript(exponent);
}

std::string pretty(const std::string& name) {
    static constexpr std::array<std::array<const char*, 2>, 34> letters{{
        {"alpha", "α"}, {"beta", "β"},    {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"eps", "ε"},
        {"zeta", "ζ"},  {"eta", "η"},     {"theta", "θ"}, {"iota", "ι"},   {"kappa", "κ"},   {"lambda", "λ"},
        {"mu", "μ"},    {"nu", "ν"},      {"xi", "ξ"},    {"pi", "π"},     {"rho", "ρ"},     {"sigma", "σ"},
        {"tau", "τ"},   {"upsilon", "υ"}, {"phi", "φ"},   {"chi", "χ"},    {"psi", "ψ"},     {"omega", "ω"},
        {"Gamma", "Γ"}, {"Delta", "Δ"},   {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Xi", "Ξ"},      {"Pi", "Π"},
        {"Sigma", "Σ"}, {"Phi", "Φ"},     {"Psi", "Ψ"},   {"Omega", "Ω"},
    }};
    const std::size_t end = std::min(name.find_first_of("_'"), name.size());
    for (const auto& letter : letters)
        if (name.compare(0, end, letter[0]) == 0) return letter[1] + name.substr(end);
    return name;
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        default: result += c;
        }
    }
    return result;
}

} // namespace resonform::report
