// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the text of an expression into tokens.
//
//   "2.5*psi'' = 0"  ->  number 2.5, star, name psi with 2 primes, equals, number 0, end
#pragma once

#include "model/text/diagnostic.hpp"

#include <string_view>
#include <vector>

namespace resonform {

enum class TokenKind { number, name, plus, minus, star, slash, power, open, close, comma, equals, end };

struct Token {
    TokenKind kind = TokenKind::end;
    std::size_t begin = 0, end = 0; // bytes of the text
    std::size_t name_end = 0;       // name: where the primes begin
    int primes = 0;                 // name: how many follow it
};

// Errors (bad_input): a character that no expression has; Greek letters and typographic signs are
// named with their ASCII spelling.
std::vector<Token> tokenize(std::string_view text, const SourceText& source);

} // namespace resonform
