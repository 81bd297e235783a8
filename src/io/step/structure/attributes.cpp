// SPDX-License-Identifier: MIT
#include "io/step/structure/attributes.h"

#include "base/error.h"
#include "io/iges/text.h"
#include "io/step/structure/text.h"

#include <charconv>
#include <cmath>

namespace nrb::io::step {

std::string label_of(const Instances &instances, const Instance &instance) {
    constexpr size_t longest = 48; // characters of keywords print
    return "#" + std::to_string(instance.number()) + " " +
           std::string(instances.keyword(instance).substr(0, longest));
}

Attributes::Attributes(const Instances &instances, const Instance &instance)
    : instances_(instances), instance_(instance), lexer_(instances.text(), instance.offset()) {
    complex_ = lexer_.peek_character() == '(';
    if (complex_) {
        lexer_.skip_character();
        return;
    }
    lexer_.next();
    const Token token = lexer_.next();
    if (!token.is('(')) {
        fail(Status::syntax, "%s: found %s, expected '(' after the keyword", label().c_str(),
             iges::excerpt(token.text).c_str());
    }
}

std::string Attributes::label() const {
    return label_of(instances_, instance_);
}

void Attributes::fail_attribute(Status status, const char *name, const std::string &what) const {
    const std::string place = depth_ > 0 ? "[" + std::to_string(index_ - 1) + "]" : std::string();
    fail(status, "%s: %s%s: %s", label().c_str(), name, place.c_str(), what.c_str());
}

void Attributes::fail_token(const Token &token, const char *name, const char *expected) const {
    const bool missing = token.is(')') || token.is(';') || token.kind == TokenKind::end;
    fail_attribute(Status::syntax, name,
                   (missing ? std::string("is missing") : "found " + iges::excerpt(token.text)) +
                       ", expected " + expected);
}

bool Attributes::has_part(std::string_view type) const {
    if (!complex_) {
        return instances_.keyword(instance_) == type;
    }
    Lexer lexer(instances_.text(), instance_.offset());
    lexer.next();
    for (Token token = lexer.next(); token.kind == TokenKind::keyword; token = lexer.next()) {
        if (token.text == type) {
            return true;
        }
        if (!lexer.next().is('(') || !lexer.skip_list()) {
            return false;
        }
    }
    return false;
}

void Attributes::part(std::string_view type) {
    if (!complex_) {
        return;
    }
    lexer_ = Lexer(instances_.text(), instance_.offset());
    lexer_.next();
    first_ = true;
    for (Token token = lexer_.next(); token.kind == TokenKind::keyword; token = lexer_.next()) {
        const bool opened = lexer_.next().is('(');
        if (opened && token.text == type) {
            return;
        }
        if (!opened || !lexer_.skip_list()) {
            break;
        }
    }
    fail(Status::syntax, "%s: no part %.*s", label().c_str(), static_cast<int>(type.size()), type.data());
}

// Goes behind the comma before a value.
void Attributes::begin_value(const char *name) {
    ++index_;
    if (first_) {
        first_ = false;
        return;
    }
    if (lexer_.peek_character() != ',') {
        fail_token(lexer_.next(), name, "',' and a value");
    }
    lexer_.skip_character();
}

Token Attributes::take(const char *name, TokenKind kind, const char *expected) {
    begin_value(name);
    const Token token = lexer_.next();
    if (token.kind != kind) {
        fail_token(token, name, expected);
    }
    return token;
}

// Goes behind $ or *.
bool Attributes::take_unset(const char *name) {
    const char c = upcoming();
    if (c != '$' && c != '*') {
        return false;
    }
    begin_value(name);
    lexer_.next();
    return true;
}

char Attributes::upcoming() {
    Lexer ahead = lexer_;
    if (ahead.peek_character() == ',' && !first_) {
        ahead.skip_character();
    }
    const char c = ahead.peek_character();
    const bool digit = (c >= '0' && c <= '9') || c == '-' || c == '+';
    const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '!';
    return digit ? '0' : (letter ? 'A' : c);
}

// A token that std::from_chars reads whole. It takes no plus sign, and "inf" begins with no digit.
double Attributes::number(const char *name) {
    begin_value(name);
    const Token token = lexer_.next();
    const char *begin = token.text.data(), *end = begin + token.text.size();
    double value = 0;
    if (token.kind == TokenKind::number) {
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error == std::errc() && stop == end && std::isfinite(value)) {
            return value;
        }
        if (iges::parse_real(token.text, value)) {
            return value;
        }
    }
    fail_token(token, name, "a number");
}

double Attributes::real(const char *name) {
    if (upcoming() != 'A') {
        return number(name);
    }
    open_typed(name);
    const double value = number(name);
    close(name);
    return value;
}

double Attributes::real_or(const char *name, double otherwise) {
    return take_unset(name) ? otherwise : real(name);
}

int64_t Attributes::integer(const char *name) {
    const Token token = take(name, TokenKind::number, "an integer");
    int64_t value = 0;
    if (!iges::parse_integer(token.text, value)) {
        fail_token(token, name, "an integer");
    }
    return value;
}

bool Attributes::boolean(const char *name) {
    const std::string_view value = enumeration(name);
    if (value != "T" && value != "F" && value != "U" && !value.empty()) {
        fail_attribute(Status::syntax, name, "found ." + iges::excerpt(value) + "., expected .T. or .F.");
    }
    return value == "T";
}

std::string Attributes::string(const char *name) {
    return take_unset(name) ? std::string() : decode_string(take(name, TokenKind::string, "a string").text);
}

std::string_view Attributes::enumeration(const char *name) {
    return take_unset(name) ? std::string_view() : take(name, TokenKind::enumeration, "an enumeration").text;
}

int64_t Attributes::reference(const char *name) {
    const Token token = take(name, TokenKind::instance, "an instance such as #1");
    const int64_t number = instance_number(token.text);
    if (number == 0) {
        fail_token(token, name, "# and a number from 1 to 2^48 - 1");
    }
    return number;
}

int64_t Attributes::reference_or_none(const char *name) {
    return take_unset(name) ? 0 : reference(name);
}

void Attributes::skip(const char *name) {
    begin_value(name);
    Token token = lexer_.next();
    if (token.kind == TokenKind::keyword) {
        token = lexer_.next();
    }
    const bool list = token.is('(');
    const bool no_value = token.is(')') || token.is(',') || token.is(';') || token.kind == TokenKind::end;
    if (no_value || (list && !lexer_.skip_list())) {
        fail_token(token, name, "a value");
    }
}

void Attributes::open(const char *name) {
    begin_value(name);
    const Token token = lexer_.next();
    if (!token.is('(')) {
        fail_token(token, name, "a list");
    }
    first_ = true;
    index_ = 0;
    ++depth_;
}

bool Attributes::more(const char *name) {
    const char c = lexer_.peek_character();
    if (c == ')') {
        close(name);
        return false;
    }
    if (c == '\0' || c == ';') {
        fail_token(lexer_.next(), name, "')'");
    }
    return true;
}

void Attributes::close(const char *name) {
    if (!lexer_.skip_list()) {
        fail_token(lexer_.next(), name, "')'");
    }
    first_ = false;
    --depth_;
}

std::string_view Attributes::open_typed(const char *name) {
    begin_value(name);
    const Token keyword = lexer_.next();
    const Token token = lexer_.next();
    if (keyword.kind != TokenKind::keyword || !token.is('(')) {
        fail_token(keyword, name, "a typed value");
    }
    first_ = true;
    ++depth_;
    return keyword.text;
}

} // namespace nrb::io::step
