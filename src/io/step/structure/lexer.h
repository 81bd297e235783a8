// SPDX-License-Identifier: MIT
// The tokens of an exchange structure (ISO 10303-21).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace nrb::io::step {

enum class TokenKind {
    end,         // of the text
    keyword,     // also END-ISO-10303-21, and keywords of users, which begin with '!'
    instance,    // #12
    number,      // integer or real
    string,      // text without its outer apostrophes
    binary,      // text without its quotation marks
    enumeration, // text without its points
    punctuation, // one of ( ) , = ; $ *
    unknown,     // one character that begins no token
};

struct Token {
    TokenKind kind;
    std::string_view text;

    [[nodiscard]] bool is(char c) const noexcept {
        return kind == TokenKind::punctuation && text.front() == c;
    }
};

// Takes one token after the other from a text; blanks, line ends and comments between them do not count. A string, a
// comment or an enumeration that does not end goes on to the end of the text and is `unknown`.
class Lexer {
public:
    explicit Lexer(std::string_view text, size_t at = 0) noexcept : text_(text), at_(at) {}

    Token next() noexcept;
    [[nodiscard]] Token peek() const noexcept { return Lexer(text_, at_).next(); }
    // The first character of the next token; 0 at the end.
    char peek_character() noexcept;
    void skip_character() noexcept { ++at_; }

    // Goes behind the next semicolon that is in no string and no comment; false if there is none.
    bool skip_statement() noexcept;
    // Goes behind the parenthesis that closes an open one; false if there is none. The lists in it may lie as deep
    // as they like.
    bool skip_list() noexcept;

    [[nodiscard]] size_t position() const noexcept { return at_; }
    [[nodiscard]] std::string_view text() const noexcept { return text_; }

private:
    void skip_blanks() noexcept;
    bool skip_comment() noexcept;
    bool skip_quoted(char quote) noexcept;
    Token take(TokenKind kind, size_t end) noexcept;
    Token take_quoted(TokenKind kind, char quote) noexcept;
    Token take_word(TokenKind kind, int belongs) noexcept;

    std::string_view text_;
    size_t at_;
};

// The number behind the # of an instance; 0 if it is none, and from 2^48 on.
int64_t instance_number(std::string_view text) noexcept;

// Which line of the text has a place in it, from 1.
int64_t line_at(std::string_view text, size_t at) noexcept;

} // namespace nrb::io::step
