// Strings of an exchange structure.
#include "io/step/structure/text.h"

#include <gtest/gtest.h>

namespace step_text_test {

namespace {

using nrb::io::step::decode_string;

TEST(StepText, plain_strings_stay) {
    EXPECT_EQ(decode_string(""), "");
    EXPECT_EQ(decode_string("box 1"), "box 1");
}

TEST(StepText, apostrophes_and_backslashes_are_doubled) {
    EXPECT_EQ(decode_string("O''Neil"), "O'Neil");
    EXPECT_EQ(decode_string("''''"), "''");
    EXPECT_EQ(decode_string("E:\\\\Public\\\\a.stp"), "E:\\Public\\a.stp");
    EXPECT_EQ(decode_string("\\\\X\\41"), "\\X\\41"); // the first two are one backslash, and X is a letter
}

TEST(StepText, escapes_are_characters) {
    EXPECT_EQ(decode_string("\\X\\E9"), "\xc3\xa9");                        // e acute
    EXPECT_EQ(decode_string("\\X2\\00E903B1\\X0\\x"), "\xc3\xa9\xce\xb1x"); // and alpha
    EXPECT_EQ(decode_string("\\X4\\0001F600\\X0\\"), "\xf0\x9f\x98\x80");
    EXPECT_EQ(decode_string("\\X2\\D83DDE00\\X0\\"), "\xf0\x9f\x98\x80"); // two surrogates
    EXPECT_EQ(decode_string("\\S\\i"), "\xc3\xa9");                       // E9 = 'i' + 80
    EXPECT_EQ(decode_string("\\PB\\\\S\\i"), "\xc3\xa9");                 // E9 of ISO 8859-2 is the same
    EXPECT_EQ(decode_string("\\PG\\\\S\\a"), "\xce\xb1");                 // E1 of ISO 8859-7 is alpha
    EXPECT_EQ(decode_string("\\PE\\\\S\\P"), "\xd0\xb0");                 // D0 of ISO 8859-5 is a
    EXPECT_EQ(decode_string("\\PI\\\\S\\p"), "\xc4\x9f");                 // F0 of ISO 8859-9 is g breve
    EXPECT_EQ(decode_string("\\PF\\\\S\\!"), "\xef\xbf\xbd");             // A1 of ISO 8859-6 is none
}

TEST(StepText, what_is_no_escape_stays) {
    for (const char *text : {"\\", "\\X", "\\X\\", "\\X\\4", "\\X\\G0", "\\X2\\0041", "\\X2\\004\\X0\\",
                             "\\X2\\00G1\\X0\\", "\\X4\\0041\\X0\\", "\\S\\", "\\PZ\\", "\\P", "\\Q\\"}) {
        EXPECT_EQ(decode_string(text), text);
    }
    EXPECT_EQ(decode_string("\\X2\\00410042\\X0"), "\\X2\\00410042\\X0");
}

TEST(StepText, no_character_that_is_none_comes_out) {
    EXPECT_EQ(decode_string("\\X2\\D83D\\X0\\"), "\xef\xbf\xbd"); // half of one
    EXPECT_EQ(decode_string("\\X2\\DE000041\\X0\\"), "\xef\xbf\xbd"
                                                     "A"); // the other half
    EXPECT_EQ(decode_string("\\X2\\D83DD83D\\X0\\"), "\xef\xbf\xbd\xef\xbf\xbd");
    EXPECT_EQ(decode_string("\\X4\\FFFFFFFF\\X0\\"), "\xef\xbf\xbd");
    EXPECT_EQ(decode_string("\\X\\00a\\X2\\0000\\X0\\"), "?a?");
    EXPECT_EQ(decode_string(std::string("a\0b\tc", 5)), "a?b?c");
    EXPECT_EQ(decode_string("a\r\nb"), "ab"); // lines of the file are not part of strings
}

TEST(StepText, bytes_are_utf8_or_latin) {
    EXPECT_EQ(decode_string("\xc3\xa9"), "\xc3\xa9");
    EXPECT_EQ(decode_string("\xe9t\xe9"), "\xc3\xa9t\xc3\xa9");
    EXPECT_EQ(decode_string("\xf0\x9f\x98\x80"), "\xf0\x9f\x98\x80");
    // overlong, a surrogate, beyond Unicode, cut off: not UTF-8
    for (const char *text :
         {"\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xc3", "\xf0\x9f\x98"}) {
        EXPECT_NE(decode_string(text), text);
    }
}

} // namespace

} // namespace step_text_test
