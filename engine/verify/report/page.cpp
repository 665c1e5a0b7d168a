// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <regex>

namespace resonform::report {

namespace {

std::string superscript(int number) {
    static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string result = number < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(number))) result += digits[c - '0'];
    return result;
}

// Where words of the terminal begin with one of these, signs stand instead.
constexpr std::array<std::array<const char*, 2>, 6> arrows{{
    {"->", "→"},
    {"<=", "≤"},
    {">=", "≥"},
    {"+-", "±"},
    {"...", "…"},
    {"*", "·"},
}};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// "^3", "^(7/2)" or "^-1" at `at`, which is moved behind it: whole numbers are raised.
std::string raised(const std::string& text, std::size_t& at) {
    std::size_t end = at + 1;
    if (end < text.size() && text[end] == '-') ++end;
    const std::size_t digits = end;
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
    if (end == digits || end > digits + 3) return std::string(1, text[at++]);
    const std::string number = text.substr(at + 1, end - at - 1);
    at = end;
    return superscript(std::atoi(number.c_str()));
}

// "2.5e-08" at `at` -> "2.5·10⁻⁸"; "" if no such number begins there.
std::string power_of_ten(const std::string& text, std::size_t& at) {
    static const std::regex number("^([0-9.]+)e([+-]?[0-9]+)");
    std::smatch found;
    if (!std::regex_search(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), found, number))
        return "";
    at += static_cast<std::size_t>(found.length());
    return (found[1] == "1" ? "" : found[1].str() + "·") + "10" +
           superscript(std::atoi(found[2].str().c_str()));
}

} // namespace

std::string short_number(double value, int digits) {
    if (!std::isfinite(value)) return "–";
    if (value == 0) return "0";
    if (std::abs(value) >= 0.01 && std::abs(value) < 1000) return fmt::format("{:.{}g}", value, digits);
    const std::string text = fmt::format("{:.{}e}", value, digits - 1); // "2.53e-03"
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
    std::string result;
    for (std::size_t at = 0; at < name.size();) { // word by word: C_delta
        const std::size_t end = std::min(name.find_first_of("_'", at), name.size());
        const std::string word = name.substr(at, end - at);
        const auto letter =
            std::find_if(letters.begin(), letters.end(), [&](const auto& l) { return word == l[0]; });
        result += letter == letters.end() ? word : (*letter)[1];
        if (end < name.size()) result += name[end];
        at = end + 1;
    }
    return result;
}

std::string power_of_eps(const Rational& exponent) {
    if (exponent == 1) return "ε";
    const std::string text = to_string(exponent);
    return text.find('/') == std::string::npos ? "ε" + superscript(std::atoi(text.c_str()))
                                               : "ε^(" + text + ")";
}

std::string typeset(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
            const std::size_t begin = at;
            while (at < text.size() && (is_word(text[at]) || text[at] == '\'')) ++at;
            result += pretty(text.substr(begin, at - begin));
            continue;
        }
        if (std::isdigit(static_cast<unsigned char>(c)) != 0 && (at == 0 || !is_word(text[at - 1])))
            if (const std::string number = power_of_ten(text, at); !number.empty()) {
                result += number;
                continue;
            }
        if (c == '^') {
            result += raised(text, at);
            continue;
        }
        const auto arrow = std::find_if(arrows.begin(), arrows.end(), [&](const auto& a) {
            return text.compare(at, std::strlen(a[0]), a[0]) == 0;
        });
        result += arrow == arrows.end() ? std::string(1, c) : (*arrow)[1];
        at += arrow == arrows.end() ? 1 : std::strlen((*arrow)[0]);
    }
    return result;
}

std::string plain_number(double value) { return typeset(fmt::format("{:g}", value)); }

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
