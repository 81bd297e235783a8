// SPDX-License-Identifier: MIT
#include "io/step/structure/exchange.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/text.h"
#include "io/step/structure/text.h"

#include <algorithm>

namespace nrb::io::step {
namespace {

constexpr std::string_view start_mark = "ISO-10303-21";
constexpr std::string_view end_mark = "END-ISO-10303-21";

// Where the first word stands: behind a byte order mark, blanks and comments.
size_t first_word(std::string_view text) noexcept {
    constexpr std::string_view byte_order_mark("\xef\xbb\xbf");
    Lexer lexer(text, text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    lexer.peek_character();
    return lexer.position();
}

class Structure {
public:
    explicit Structure(std::string_view text) noexcept : lexer_(text) {}

    Exchange run() {
        lexer_ = Lexer(lexer_.text(), first_word(lexer_.text()));
        lexer_.next();
        expect(';', "after ISO-10303-21");
        Token token = take_keyword("HEADER, DATA or END-ISO-10303-21");
        for (; token.text != end_mark; token = take_keyword("HEADER, DATA or END-ISO-10303-21")) {
            read_section(token.text);
        }
        return {std::move(schemas_), Instances(lexer_.text(), std::move(instances_))};
    }

private:
    void read_section(std::string_view name) {
        if (!lexer_.skip_statement()) {
            fail_end();
        }
        if (name == "HEADER") {
            read_header();
        } else if (name == "DATA") {
            read_data();
        } else {
            pass_section();
        }
    }

    void read_header() {
        for (Token token = take_keyword("an entity or ENDSEC"); token.text != "ENDSEC";
             token = take_keyword("an entity or ENDSEC")) {
            if (token.text == "FILE_SCHEMA") {
                read_schemas();
            }
            end_statement();
        }
        expect(';', "after ENDSEC");
    }

    // All strings: the names, each perhaps with an object identifier in braces.
    void read_schemas() {
        for (Token token = lexer_.peek(); token.kind != TokenKind::end && !token.is(';');
             token = lexer_.peek()) {
            lexer_.next();
            if (token.kind == TokenKind::string) {
                const std::string name = decode_string(token.text);
                schemas_.push_back(name.substr(0, name.find_first_of(" {")));
            }
        }
    }

    void read_data() {
        while (true) {
            const Token token = lexer_.next();
            if (token.kind == TokenKind::keyword && token.text == "ENDSEC") {
                expect(';', "after ENDSEC");
                return;
            }
            if (token.kind != TokenKind::instance) {
                fail_token(token, "an instance name such as #1, or ENDSEC");
            }
            add_instance(token);
        }
    }

    void add_instance(const Token &name) {
        const int64_t number = instance_number(name.text);
        if (number == 0) {
            fail_token(name, "# and a number from 1 to 2^48 - 1");
        }
        expect('=', "after an instance name");
        const char first = lexer_.peek_character();
        const size_t offset = lexer_.position();
        instances_.emplace_back(number, first == '(' ? complex_kind() : simple_kind(), offset);
        const size_t begin = lexer_.position();
        end_statement();
        count_work(static_cast<int64_t>(lexer_.position() - begin) / 8);
    }

    // Neighbours often have the same keyword.
    Kind simple_kind() {
        const Token token = lexer_.next();
        if (token.kind != TokenKind::keyword) {
            fail_token(token, "the keyword of an entity, or '('");
        }
        if (token.text != last_keyword_) {
            last_keyword_ = token.text;
            last_kind_ = kind_of(token.text);
        }
        return last_kind_;
    }

    Kind complex_kind() {
        Kind kind = Kind::other;
        lexer_.next();
        Token token = lexer_.next();
        for (; token.kind == TokenKind::keyword; token = lexer_.next()) {
            kind = std::max(kind, kind_of(token.text));
            expect('(', "after the keyword of a part");
            if (!lexer_.skip_list()) {
                fail_syntax(lexer_.position(), "a part of a complex instance does not end");
            }
        }
        if (!token.is(')')) {
            fail_token(token, "the keyword of a part, or ')'");
        }
        return kind;
    }

    void pass_section() {
        while (true) {
            const Token token = lexer_.peek();
            if (token.kind == TokenKind::end) {
                fail_end();
            }
            end_statement();
            if (token.text == "ENDSEC") {
                return;
            }
        }
    }

    void end_statement() {
        if (!lexer_.skip_statement()) {
            fail_end();
        }
    }

    Token take_keyword(const char *expected) {
        const Token token = lexer_.next();
        if (token.kind != TokenKind::keyword) {
            fail_token(token, expected);
        }
        return token;
    }

    void expect(char c, const char *where) {
        const Token token = lexer_.next();
        if (!token.is(c)) {
            const char text[] = {'\'', c, '\'', ' ', '\0'};
            fail_token(token, (std::string(text) + where).c_str());
        }
    }

    [[noreturn]] void fail_token(const Token &token, const char *expected) const {
        if (token.kind == TokenKind::end) {
            fail_end();
        }
        const auto at = static_cast<size_t>(token.text.data() - lexer_.text().data());
        fail(Status::syntax, "line %lld: found %s, expected %s",
             static_cast<long long>(line_at(lexer_.text(), at)), iges::excerpt(token.text).c_str(), expected);
    }
    [[noreturn]] void fail_syntax(size_t at, const char *what) const {
        fail(Status::syntax, "line %lld: %s", static_cast<long long>(line_at(lexer_.text(), at)), what);
    }
    [[noreturn]] void fail_end() const {
        fail(Status::truncated, "line %lld: the file ends before END-ISO-10303-21",
             static_cast<long long>(line_at(lexer_.text(), lexer_.text().size())));
    }

    Lexer lexer_;
    std::string_view last_keyword_;
    Kind last_kind_ = Kind::other;
    std::vector<std::string> schemas_;
    std::vector<Instance> instances_;
};

} // namespace

bool begins_step(std::span<const char> bytes) noexcept {
    const std::string_view text(bytes.data(), bytes.size());
    return text.substr(first_word(text)).starts_with(start_mark);
}

Exchange read_exchange(std::span<const char> bytes) {
    return Structure({bytes.data(), bytes.size()}).run();
}

} // namespace nrb::io::step
