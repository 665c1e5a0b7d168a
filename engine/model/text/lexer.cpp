// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/lexer.hpp"

#include "algebra/number/error.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace resonform {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

using Spelling = std::pair<std::string_view, std::string_view>;

// Characters that people paste from papers, with the ASCII spelling of this reader.
constexpr std::array<Spelling, 50> spellings = {{
    {"α", "alpha"},  {"β", "beta"},    {"γ", "gamma"}, {"δ", "delta"},     {"ε", "eps"},
    {"ϵ", "eps"},    {"ζ", "zeta"},    {"η", "eta"},   {"θ", "theta"},     {"ϑ", "theta"},
    {"ι", "iota"},   {"κ", "kappa"},   {"λ", "lam"},   {"μ", "mu"},        {"ν", "nu"},
    {"ξ", "xi"},     {"ο", "o"},       {"π", "pi"},    {"ρ", "rho"},       {"σ", "sigma"},
    {"τ", "tau"},    {"υ", "upsilon"}, {"φ", "phi"},   {"ϕ", "phi"},       {"χ", "chi"},
    {"ψ", "psi"},    {"ω", "omega"},   {"Γ", "Gamma"}, {"Δ", "Delta"},     {"Θ", "Theta"},
    {"Λ", "Lambda"}, {"Ξ", "Xi"},      {"Σ", "Sigma"}, {"Φ", "Phi"},       {"Ψ", "Psi"},
    {"Ω", "Omega"},  {"−", "-"},       {"–", "-"},     {"—", "-"},         {"·", "*"},
    {"×", "*"},      {"⋅", "*"},       {"÷", "/"},     {"²", "^2"},        {"³", "^3"},
    {"′", "'"},      {"″", "''"},      {"’", "'"},     {"√", "sqrt(...)"}, {"\xC2\xA0", "a plain space"},
}};

[[noreturn]] void refuse_character(std::string_view text, std::size_t at, const SourceText& source) {
    Diagnostic d;
    d.rule = "an expression is written with ASCII letters, digits, + - * / ^ ' ( ) = and spaces";
    d.place = place_at(source, text, at);
    std::size_t end = at + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
    d.value = excerpt(text, at, end);
    d.hint = "remove it or spell it in ASCII";
    for (const Spelling& s : spellings) {
        if (text.substr(at, s.first.size()) == s.first) d.hint = "write " + std::string(s.second);
    }
    if (text[at] == '"') d.hint = "write '' (two apostrophes) for a second derivative";
    if (text[at] == '[' || text[at] == '{') d.hint = "write (";
    if (text[at] == ']' || text[at] == '}') d.hint = "write )";
    bad_input(Reason::syntax, d);
}

// 12, 0.25, 1.5e-3; the exponent only where digits follow, so that "2e" stays "2" and "e".
std::size_t end_of_number(std::string_view text, std::size_t at) {
    while (at < text.size() && is_digit(text[at])) ++at;
    if (at + 1 < text.size() && text[at] == '.' && is_digit(text[at + 1])) {
        ++at;
        while (at < text.size() && is_digit(text[at])) ++at;
    }
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        std::size_t digits = at + 1;
        if (digits < text.size() && (text[digits] == '+' || text[digits] == '-')) ++digits;
        if (digits < text.size() && is_digit(text[digits])) {
            at = digits;
            while (at < text.size() && is_digit(text[at])) ++at;
        }
    }
    return at;
}

Token name_at(std::string_view text, std::size_t at) {
    Token token;
    token.kind = TokenKind::name;
    token.begin = at;
    while (at < text.size() && (is_letter(text[at]) || is_digit(text[at]) || text[at] == '_')) ++at;
    token.name_end = at;
    while (at < text.size() && text[at] == '\'') ++at;
    token.end = at;
    token.primes = static_cast<int>(at - token.name_end);
    return token;
}

Token operator_at(std::string_view text, std::size_t at, const SourceText& source) {
    Token token;
    token.begin = at;
    token.end = at + 1;
    switch (text[at]) {
    case '+': token.kind = TokenKind::plus; break;
    case '-': token.kind = TokenKind::minus; break;
    case '/': token.kind = TokenKind::slash; break;
    case '^': token.kind = TokenKind::power; break;
    case '(': token.kind = TokenKind::open; break;
    case ')': token.kind = TokenKind::close; break;
    case ',': token.kind = TokenKind::comma; break;
    case '=': token.kind = TokenKind::equals; break;
    case '*':
        token.kind = TokenKind::star;
        if (at + 1 < text.size() && text[at + 1] == '*') {
            token.kind = TokenKind::power;
            token.end = at + 2;
        }
        break;
    case '\'':
        bad_input(Reason::syntax, {"primes follow the name of a variable directly", "'",
                                   "write the derivative as in psi', and of an expression in full",
                                   place_at(source, text, at)});
    case '.':
        bad_input(Reason::syntax,
                  {"a number has a digit before and after its decimal point", excerpt(text, at, at + 2),
                   "write 0.5 or 1.0", place_at(source, text, at)});
    default: refuse_character(text, at, source);
    }
    return token;
}

} // namespace

std::vector<Token> tokenize(std::string_view text, const SourceText& source) {
    std::vector<Token> tokens;
    std::size_t at = 0;
    while (at < text.size()) {
        if (is_space(text[at])) {
            ++at;
            continue;
        }
        Token token;
        if (is_digit(text[at])) {
            token.kind = TokenKind::number;
            token.begin = at;
            token.end = end_of_number(text, at);
        } else if (is_letter(text[at])) {
            token = name_at(text, at);
        } else {
            token = operator_at(text, at, source);
        }
        at = token.end;
        tokens.push_back(token);
    }
    Token last;
    last.begin = last.end = text.size();
    tokens.push_back(last);
    return tokens;
}

} // namespace resonform
