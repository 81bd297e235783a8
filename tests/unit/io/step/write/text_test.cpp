// Numbers and names as Part 21 has them.
#include "io/step/structure/text.h"
#include "io/step/write/exchange_text.h"

#include "base/error.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace step_write_text_test {
namespace {

using namespace nrb;
using namespace nrb::io::step;

std::string encoded(std::string_view text) {
    std::string raw;
    append_encoded(text, raw);
    return raw;
}

std::string real(double value) {
    ExchangeText text("");
    text.add("X", value);
    const std::string all = text.take();
    return all.substr(5, all.size() - 8);
}

TEST(StepWriteText, NumbersHaveAPointAndAllTheirDigits) {
    EXPECT_EQ(real(0), "0.");
    EXPECT_EQ(real(-0.0), "-0.");
    EXPECT_EQ(real(1), "1.");
    EXPECT_EQ(real(-12.5), "-12.5");
    EXPECT_EQ(real(0.1), "0.1");
    EXPECT_EQ(real(1e-7), "1.E-07");
    EXPECT_EQ(real(2.5e300), "2.5E+300");
    EXPECT_EQ(real(5e-324), "5.E-324");
}

TEST(StepWriteText, NumbersReadBackBitForBit) {
    std::mt19937_64 bits(1);
    for (int i = 0; i < 10000; ++i) {
        const auto value = std::bit_cast<double>(bits());
        if (std::isfinite(value)) {
            const std::string text = real(value);
            EXPECT_NE(text.find('.'), std::string::npos);
            double again = 0;
            std::from_chars(text.data(), text.data() + text.size(), again);
            EXPECT_EQ(std::bit_cast<uint64_t>(again), std::bit_cast<uint64_t>(value)) << text;
        }
    }
}

TEST(StepWriteText, NumbersThatAreNoneAreRefused) {
    EXPECT_THROW(real(std::numeric_limits<double>::infinity()), Error);
    EXPECT_THROW(real(std::nan("")), Error);
}

TEST(StepWriteText, NamesAreEncoded) {
    EXPECT_EQ(encoded(""), "");
    EXPECT_EQ(encoded("it's a\\b"), "it''s a\\\\b");
    EXPECT_EQ(encoded("Stra\xC3\x9F"
                      "e"),
              "Stra\\X2\\00DF\\X0\\e");
    EXPECT_EQ(encoded("\xE2\x82\xAC\xE2\x82\xAC"), "\\X2\\20AC20AC\\X0\\");
    EXPECT_EQ(encoded("a\xF0\x9F\x94\xA9\xC3\xA9"), "a\\X4\\0001F529\\X0\\\\X2\\00E9\\X0\\");
    EXPECT_EQ(encoded("a\tb\x7F\xC2\x85"), "a?b??");
    EXPECT_EQ(encoded("\xFF'"), "\\X2\\00FF\\X0\\''"); // no UTF-8, so ISO 8859-1
}

// Any text becomes one of which the same text is made, and that is encoded alike.
TEST(StepWriteText, NamesReadBack) {
    std::mt19937 random(2);
    const std::string pieces[] = {"'",  "\\", "\\X2\\",   "\\X0\\",           "\\S\\",
                                  "''", "a",  "\xC3\xBC", "\xF0\x9F\x94\xA9", " ",
                                  "#",  ";",  "*/"};
    for (int i = 0; i < 2000; ++i) {
        std::string text;
        for (unsigned k = random() % 8; k > 0; --k) {
            text += pieces[random() % std::size(pieces)];
        }
        EXPECT_EQ(decode_string(encoded(text)), text);
    }
    for (int i = 0; i < 2000; ++i) {
        std::string text;
        for (unsigned k = random() % 8; k > 0; --k) {
            text += static_cast<char>(random() % 256);
        }
        const std::string once = decode_string(encoded(text));
        EXPECT_EQ(decode_string(encoded(once)), once);
    }
}

TEST(StepWriteText, LongListsAreSeveralLines) {
    const std::vector<int64_t> many(1000, 123456);
    ExchangeText text("");
    text.add("X", Refs{many});
    const std::string all = text.take();
    size_t longest = 0, start = 0;
    for (size_t end = all.find('\n'); end != std::string::npos;
         start = end + 1, end = all.find('\n', start)) {
        longest = std::max(longest, end - start);
    }
    EXPECT_LE(longest, 84U);
    EXPECT_EQ(static_cast<size_t>(std::count(all.begin(), all.end(), ',')), many.size() - 1);
}

} // namespace
} // namespace step_write_text_test
