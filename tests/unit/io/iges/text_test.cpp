// Numbers of IGES: correctly rounded, in any locale, and nothing else taken for a number.
#include "io/iges/text.h"

#include <clocale>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace text_test {

namespace {

using nrb::io::iges::excerpt;
using nrb::io::iges::parse_integer;
using nrb::io::iges::parse_real;
using nrb::io::iges::printable;
using nrb::io::iges::trim;

double real(std::string_view text) {
    double value = 0;
    return parse_real(text, value) ? value : std::numeric_limits<double>::quiet_NaN();
}

bool is_real(std::string_view text) {
    double value = 0;
    return parse_real(text, value);
}

TEST(IgesText, reads_every_written_form_of_real) {
    EXPECT_EQ(real("1"), 1.0);
    EXPECT_EQ(real("1."), 1.0);
    EXPECT_EQ(real(".5"), 0.5);
    EXPECT_EQ(real("+2.25"), 2.25);
    EXPECT_EQ(real("-0.125"), -0.125);
    EXPECT_EQ(real("1.5E2"), 150.0);
    EXPECT_EQ(real("1.5E+02"), 150.0);
    EXPECT_EQ(real("-1.5e-1"), -0.15);
}

TEST(IgesText, reads_double_precision_exponents) {
    EXPECT_EQ(real("1.0D0"), 1.0);
    EXPECT_EQ(real("1.D+3"), 1000.0);
    EXPECT_EQ(real("2.5d-3"), 2.5e-3);
    EXPECT_EQ(real("-117.000000000001D0"), -117.000000000001);
}

// Halfway cases and long digit strings that a reader with accumulated products gets wrong in the last bit.
TEST(IgesText, rounds_correctly) {
    EXPECT_EQ(real("0.1"), 0x1.999999999999ap-4);
    EXPECT_EQ(real("9007199254740993"), 0x1p53);
    EXPECT_EQ(real("9007199254740993.00000000000000000000000000000000000001"), 0x1.0000000000001p53);
    EXPECT_EQ(real("2.2250738585072011D-308"), 0x0.fffffffffffffp-1022);
    EXPECT_EQ(real("1.7976931348623157D308"), std::numeric_limits<double>::max());
}

TEST(IgesText, too_small_is_zero_and_too_large_is_refused) {
    EXPECT_EQ(real("1.E-400"), 0.0);
    EXPECT_EQ(real("-1.D-999999999999999999999"), 0.0);
    EXPECT_TRUE(std::signbit(real("-1.E-400")));
    EXPECT_EQ(real("0.E999"), 0.0);
    EXPECT_FALSE(is_real("1.E400"));
    EXPECT_FALSE(is_real("1.E99999999999999999999"));
    EXPECT_FALSE(is_real("1.8D308"));
    EXPECT_EQ(real("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_FALSE(is_real("1" + std::string(400, '0')));
    EXPECT_EQ(real("1" + std::string(400, '0') + "E-400"), 1.0);
}

TEST(IgesText, refuses_what_is_no_real) {
    for (const char *text :
         {"",     "+",  "-",    ".",   "inf", "INF",   "nan",   "-nan", "1.5E", "1.5D",     "1,5",
          "1.5 ", " 1", "0x10", "--1", "+-1", "1D2D3", "1E2D3", "D2",   "1..2", "infinity", "1e+-5"}) {
        EXPECT_FALSE(is_real(text)) << "'" << text << "'";
    }
}

TEST(IgesText, ignores_the_locale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    bool set = false;
    for (const char *name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
        set = set || std::setlocale(LC_ALL, name) != nullptr;
    }
    EXPECT_EQ(real("1.5D0"), 1.5);
    std::setlocale(LC_ALL, before.c_str());
    if (!set) {
        GTEST_SKIP() << "no locale with a decimal comma is installed";
    }
}

TEST(IgesText, reads_integers) {
    int64_t value = 0;
    EXPECT_TRUE(parse_integer("-17", value));
    EXPECT_EQ(value, -17);
    EXPECT_TRUE(parse_integer("+0000123", value));
    EXPECT_EQ(value, 123);
    EXPECT_TRUE(parse_integer("9223372036854775807", value));
    EXPECT_EQ(value, std::numeric_limits<int64_t>::max());
    for (const char *text : {"", "-", "1.", "1a", "9223372036854775808", "+-3", "--3", " 3"}) {
        EXPECT_FALSE(parse_integer(text, value)) << "'" << text << "'";
    }
}

TEST(IgesText, trims_blanks_only) {
    EXPECT_EQ(trim("  a b "), "a b");
    EXPECT_EQ(trim("    "), "");
    EXPECT_EQ(trim(""), "");
}

TEST(IgesText, excerpts_print_and_are_short) {
    EXPECT_EQ(excerpt(std::string_view("a\0b\n\xff", 5)), "a?b??");
    EXPECT_EQ(excerpt(std::string(100, 'x')), std::string(24, 'x') + "...");
}

TEST(IgesText, names_keep_letters_and_lose_controls) {
    EXPECT_EQ(printable(std::string_view("na\0me\t\xc3\xa4", 8)), "na?me?\xc3\xa4");
}

} // namespace

} // namespace text_test
