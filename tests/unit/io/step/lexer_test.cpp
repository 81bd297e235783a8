// The tokens of an exchange structure.
#include "io/step/structure/lexer.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace step_lexer_test {

namespace {

using nrb::io::step::Lexer;
using nrb::io::step::Token;
using nrb::io::step::TokenKind;

std::vector<std::pair<TokenKind, std::string>> tokens_of(std::string_view text) {
    Lexer lexer(text);
    std::vector<std::pair<TokenKind, std::string>> tokens;
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
        tokens.emplace_back(token.kind, std::string(token.text));
    }
    return tokens;
}

std::pair<TokenKind, std::string> only(std::string_view text) {
    const auto tokens = tokens_of(text);
    EXPECT_EQ(tokens.size(), 1U) << text;
    return tokens.at(0);
}

TEST(StepLexer, one_token_of_each_kind) {
    using enum TokenKind;
    EXPECT_EQ(only("B_SPLINE_CURVE"), std::pair(keyword, std::string("B_SPLINE_CURVE")));
    EXPECT_EQ(only("!MINE"), std::pair(keyword, std::string("!MINE")));
    EXPECT_EQ(only("END-ISO-10303-21"), std::pair(keyword, std::string("END-ISO-10303-21")));
    EXPECT_EQ(only("#12"), std::pair(instance, std::string("#12")));
    EXPECT_EQ(only("-1.5E+03"), std::pair(number, std::string("-1.5E+03")));
    EXPECT_EQ(only(".5"), std::pair(number, std::string(".5")));
    EXPECT_EQ(only("+7"), std::pair(number, std::string("+7")));
    EXPECT_EQ(only("'it''s; (not) /* one */'"), std::pair(string, std::string("it''s; (not) /* one */")));
    EXPECT_EQ(only("''"), std::pair(string, std::string()));
    EXPECT_EQ(only("''''"), std::pair(string, std::string("''")));
    EXPECT_EQ(only("\"0F\""), std::pair(binary, std::string("0F")));
    EXPECT_EQ(only(".T."), std::pair(enumeration, std::string("T")));
    EXPECT_EQ(only(".CURVE_3D."), std::pair(enumeration, std::string("CURVE_3D")));
    for (const char *c : {"(", ")", ",", "=", ";", "$", "*"}) {
        EXPECT_EQ(only(c), std::pair(punctuation, std::string(c)));
    }
    for (const char *c : {"?", "/", "@", "\x80", "."}) {
        EXPECT_EQ(only(c), std::pair(unknown, std::string(c)));
    }
}

TEST(StepLexer, blanks_line_ends_and_comments_do_not_count) {
    EXPECT_EQ(tokens_of(" #1\r\n=\t/* ; ' */A/**/(/***/)\v;\f").size(), 6U);
    EXPECT_TRUE(tokens_of("/* nothing */ \n").empty());
    EXPECT_EQ(tokens_of("/* /* */ A").size(), 1U); // comments do not nest
    EXPECT_EQ(tokens_of("#1/*2*/3").size(), 2U);
}

TEST(StepLexer, what_does_not_end_is_unknown) {
    EXPECT_EQ(tokens_of("'abc''").front().first, TokenKind::unknown);
    EXPECT_EQ(tokens_of("\"abc").front().first, TokenKind::unknown);
    EXPECT_EQ(tokens_of("/* abc").front().first, TokenKind::unknown);
    EXPECT_EQ(tokens_of(".ABC").front().first, TokenKind::unknown);
}

TEST(StepLexer, statements_end_at_semicolons_outside_of_strings_and_comments) {
    const std::string text = "A(';','it''s;')/* ; */,\";\";B;";
    Lexer lexer(text);
    ASSERT_TRUE(lexer.skip_statement());
    EXPECT_EQ(text.substr(lexer.position()), "B;");
    ASSERT_TRUE(lexer.skip_statement());
    EXPECT_FALSE(lexer.skip_statement());
    EXPECT_EQ(lexer.position(), text.size());
    for (const char *open : {"A(';", "A/* ;", "A", "'", ""}) {
        Lexer endless{std::string_view(open)};
        EXPECT_EQ(endless.skip_statement(), std::string_view(open) == "A/* ;")
            << open; // a slash that begins nothing
    }
}

TEST(StepLexer, lists_of_any_depth_are_skipped) {
    const std::string deep = std::string(100000, '(') + std::string(100000, ')') + ")x";
    Lexer lexer(deep);
    ASSERT_TRUE(lexer.skip_list());
    EXPECT_EQ(deep.substr(lexer.position()), "x");
    Lexer in_string{std::string_view("')',')');")};
    ASSERT_TRUE(in_string.skip_list());
    EXPECT_EQ(in_string.position(), 8U);
    Lexer open{std::string_view("((1);)")};
    EXPECT_FALSE(open.skip_list());
}

TEST(StepLexer, instance_numbers) {
    using nrb::io::step::instance_number;
    EXPECT_EQ(instance_number("#1"), 1);
    EXPECT_EQ(instance_number("#0007"), 7);
    EXPECT_EQ(instance_number("#281474976710655"), (int64_t{1} << 48) - 1);
    for (const char *text :
         {"", "#", "#0", "#-1", "#1A", "12", "#281474976710656", "#99999999999999999999999"}) {
        EXPECT_EQ(instance_number(text), 0) << text;
    }
}

TEST(StepLexer, lines_are_counted_whatever_ends_them) {
    using nrb::io::step::line_at;
    EXPECT_EQ(line_at("a\nb\nc", 4), 3);
    EXPECT_EQ(line_at("a\r\nb\r\nc", 6), 3);
    EXPECT_EQ(line_at("a\rb\rc", 4), 3);
}

} // namespace

} // namespace step_lexer_test
