// SPDX-License-Identifier: MIT
#include "io/step/structure/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace nrb::io::step {
namespace {

enum Class : uint8_t { blank = 1, digit = 2, letter = 4, of_keyword = 8, of_number = 16, telling = 32 };

// The classes of a character. `telling` are those that a loop which looks for the end of a statement or of a list has to
// look at.
constexpr std::array<uint8_t, 256> classes = [] {
    std::array<uint8_t, 256> table{};
    const auto add = [&](std::string_view characters, int kind) {
        for (const char c : characters) {
            uint8_t &entry = table[static_cast<unsigned char>(c)];
            entry = static_cast<uint8_t>(entry | kind);
        }
    };
    add(" \t\n\v\f\r", blank);
    add("0123456789", digit | of_keyword | of_number);
    add("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_", letter | of_keyword);
    add("-!", of_keyword);
    add("-+.Ee", of_number);
    add("'\"/;()", telling);
    return table;
}();

bool is(char c, int kind) noexcept {
    return (classes[static_cast<unsigned char>(c)] & kind) != 0;
}

} // namespace

void Lexer::skip_blanks() noexcept {
    while (at_ < text_.size()) {
        if (is(text_[at_], blank)) {
            ++at_;
        } else if (text_[at_] != '/' || !skip_comment()) {
            return;
        }
    }
}

// False, and nothing skipped, if there is none that ends.
bool Lexer::skip_comment() noexcept {
    if (text_.substr(at_, 2) != "/*") {
        return false;
    }
    const size_t end = text_.find("*/", at_ + 2);
    if (end == std::string_view::npos) {
        return false;
    }
    at_ = end + 2;
    return true;
}

// From one quotation mark behind the next: a doubled one begins another string at once.
bool Lexer::skip_quoted(char quote) noexcept {
    const size_t end = text_.find(quote, at_ + 1);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
    return end != std::string_view::npos;
}

bool Lexer::skip_statement() noexcept {
    while (true) {
        while (at_ < text_.size() && !is(text_[at_], telling)) {
            ++at_;
        }
        if (at_ == text_.size()) {
            return false;
        }
        const char c = text_[at_];
        if (c == ';') {
            ++at_;
            return true;
        }
        if (c == '\'' || c == '"') {
            skip_quoted(c);
        } else if (c != '/' || !skip_comment()) {
            at_ += 1;
        }
    }
}

bool Lexer::skip_list() noexcept {
    for (int64_t depth = 1; at_ < text_.size();) {
        const char c = text_[at_];
        if (c == ';') {
            return false;
        }
        if (c == '\'' || c == '"') {
            skip_quoted(c);
        } else if (c != '/' || !skip_comment()) {
            depth += c == '(' ? 1 : (c == ')' ? -1 : 0);
            ++at_;
            if (depth == 0) {
                return true;
            }
        }
    }
    return false;
}

char Lexer::peek_character() noexcept {
    skip_blanks();
    return at_ < text_.size() ? text_[at_] : '\0';
}

Token Lexer::take(TokenKind kind, size_t end) noexcept {
    const size_t begin = at_;
    at_ = std::min(end, text_.size());
    return {kind, text_.substr(begin, at_ - begin)};
}

Token Lexer::take_word(TokenKind kind, int belongs) noexcept {
    size_t end = at_ + 1;
    while (end < text_.size() && is(text_[end], belongs)) {
        ++end;
    }
    return take(kind, end);
}

Token Lexer::take_quoted(TokenKind kind, char quote) noexcept {
    const size_t begin = at_ + 1;
    while (skip_quoted(quote)) {
        if (at_ == text_.size() || text_[at_] != quote) {
            return {kind, text_.substr(begin, at_ - 1 - begin)};
        }
    }
    return {TokenKind::unknown, text_.substr(begin - 1)};
}

Token Lexer::next() noexcept {
    const char c = peek_character();
    if (at_ >= text_.size()) {
        return {TokenKind::end, {}};
    }
    if (is(c, letter) || c == '!') {
        return take_word(TokenKind::keyword, of_keyword);
    }
    if (is(c, digit) || c == '-' || c == '+') {
        return take_word(TokenKind::number, of_number);
    }
    switch (c) {
    case '#':
        return take_word(TokenKind::instance, digit);
    case '\'':
        return take_quoted(TokenKind::string, c);
    case '"':
        return take_quoted(TokenKind::binary, c);
    case '.': {
        if (at_ + 1 < text_.size() &&
            is(text_[at_ + 1], digit)) { // some writers leave out the 0 before the point
            return take_word(TokenKind::number, of_number);
        }
        size_t end = at_ + 1;
        while (end < text_.size() && is(text_[end], letter | digit)) {
            ++end;
        }
        if (end == text_.size() || text_[end] != '.') {
            return take(TokenKind::unknown, at_ + 1);
        }
        const Token whole = take(TokenKind::enumeration, end + 1);
        return {whole.kind, whole.text.substr(1, whole.text.size() - 2)};
    }
    case '(':
    case ')':
    case ',':
    case '=':
    case ';':
    case '$':
    case '*':
        return take(TokenKind::punctuation, at_ + 1);
    default:
        return take(TokenKind::unknown, at_ + 1);
    }
}

int64_t instance_number(std::string_view text) noexcept {
    constexpr int64_t limit = int64_t{1} << 48;
    int64_t number = 0;
    if (text.size() < 2 || text[0] != '#' || !is(text[1], digit)) {
        return 0;
    }
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && number < limit ? number : 0;
}

int64_t line_at(std::string_view text, size_t at) noexcept {
    const std::string_view before = text.substr(0, at);
    const auto feeds = std::count(before.begin(), before.end(), '\n');
    // files of old machines end their lines by carriage returns alone
    return 1 + (feeds > 0 ? feeds : std::count(before.begin(), before.end(), '\r'));
}

} // namespace nrb::io::step
