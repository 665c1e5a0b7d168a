// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/expression.hpp"

#include "model/text/lexer.hpp"
#include "model/text/parser.hpp"

#include <algorithm>

namespace resonform {

GiNaC::ex read_expression(std::string_view text, const Scope& scope, const SourceText& source,
                          const Limits& limits) {
    return Parser(text, scope, source, limits).expression();
}

GiNaC::ex read_equation(std::string_view text, const Scope& scope, const SourceText& source,
                        const Limits& limits) {
    return Parser(text, scope, source, limits).equation();
}

std::map<std::string, int> highest_primes(std::string_view text, const SourceText& source) {
    std::map<std::string, int> highest;
    for (const Token& token : tokenize(text, source)) {
        if (token.kind != TokenKind::name) continue;
        int& primes = highest[std::string(text.substr(token.begin, token.name_end - token.begin))];
        primes = std::max(primes, token.primes);
    }
    return highest;
}

} // namespace resonform
