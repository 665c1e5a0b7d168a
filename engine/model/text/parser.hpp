// SPDX-License-Identifier: GPL-3.0-or-later
// The recursive-descent parser behind read_expression: from tokens to GiNaC, its recursion bounded by
// Limits::depth, its results by Limits::bits, terms and degree.
#pragma once

#include "model/text/growth.hpp"
#include "model/text/lexer.hpp"
#include "model/text/scope.hpp"

#include <functional>

namespace resonform {

class Parser {
public:
    // All referents must outlive the parser. Errors: text too long, bad characters.
    Parser(std::string_view text, const Scope& scope, const SourceText& source, const Limits& limits);

    GiNaC::ex expression(); // the whole text is one sum
    GiNaC::ex equation();   // the whole text is sum = sum

private:
    // A piece of the text and its value.
    struct Piece {
        GiNaC::ex value;
        Growth growth;
        std::size_t begin = 0, end = 0; // bytes of the text
    };

    Piece sum();
    Piece product();
    Piece unary();
    Piece power();
    Piece primary();
    Piece number();
    Piece name();
    Piece call();
    Piece parenthesis();
    Piece value_at(const Token& call, const FunctionValue& function, const Piece& argument);

    GiNaC::ex data_at(const Token& call, const Scope::Data& data, const Piece& argument);

    Piece reciprocal(const Piece& denominator);
    Piece raise(const Piece& base, const Piece& exponent);
    Piece raise_by_symbols(const Piece& base, const Piece& exponent);
    GiNaC::numeric checked_exponent(const Piece& exponent);
    void check_growth(const Growth& growth, std::size_t begin, std::size_t end);
    void check_argument(const std::string& function, const Piece& argument);
    void expect_end(bool equation);
    // Runs an evaluation by GiNaC; an exception of it becomes a message about text [begin, end).
    GiNaC::ex evaluate(std::size_t begin, std::size_t end, const std::function<GiNaC::ex()>& build);

    [[nodiscard]] const Token& next() const { return tokens_[at_]; }
    const Token& take() { return tokens_[at_++]; }
    bool accept(TokenKind kind);
    [[nodiscard]] std::string spelling(const Token& token) const;
    [[noreturn]] void complain(std::size_t begin, std::size_t end, std::string rule, std::string hint,
                               Reason reason = Reason::syntax) const;
    [[noreturn]] void missing_operand() const;
    [[noreturn]] void implicit_product() const;
    [[noreturn]] void unknown_name(const Token& token) const;
    void enter(std::size_t at); // one level deeper

    std::string_view text_;
    const Scope& scope_;
    const SourceText& source_;
    const Limits& limits_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

} // namespace resonform
