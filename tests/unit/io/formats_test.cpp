// Which format a file has.
#include "base/error.h"
#include "io/formats.h"
#include "support/iges_builder.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace formats_test {

namespace {

using iges_test::IgesBuilder;

std::vector<std::string> recognized(const std::string &text) {
    std::vector<std::string> names;
    for (const nrb::io::Format &format : nrb::io::formats()) {
        if (format.recognizes(text)) {
            names.emplace_back(format.name);
        }
    }
    return names;
}

const std::string iges = IgesBuilder::section_line("", 'S', 1) + "\n";
const std::string step = "ISO-10303-21;\nHEADER;\n";
const std::string compressed = IgesBuilder::section_line("", 'C', 1) + "\n";

TEST(Formats, each_is_recognized_by_its_first_line_alone) {
    EXPECT_EQ(recognized(iges), std::vector<std::string>{"IGES"});
    EXPECT_EQ(recognized(step), std::vector<std::string>{"STEP"});
    EXPECT_EQ(recognized(compressed), std::vector<std::string>{"compressed IGES"});
    for (const std::string &text : {std::string(), std::string("\n\n"), std::string("solid cube\n"),
                                    std::string(100, '\0'), std::string(72, ' ') + "T      1\n" + iges}) {
        EXPECT_TRUE(recognized(text).empty()) << text;
    }
}

TEST(Formats, what_editors_put_before_the_first_line_does_not_matter) {
    for (const std::string before : {"\xef\xbb\xbf", "\n", "  \r\n\r\n"}) {
        EXPECT_EQ(recognized(before + iges), std::vector<std::string>{"IGES"});
        EXPECT_EQ(recognized(before + step), std::vector<std::string>{"STEP"});
    }
}

TEST(Formats, blanks_and_comments_before_the_first_word_of_step_do_not_matter) {
    const std::string whole = "ISO-10303-21;HEADER;ENDSEC;DATA;ENDSEC;END-ISO-10303-21;";
    for (const std::string before :
         {" ", "\t\n \t", "\xef\xbb\xbf \r\n\t", "\v\f\n", "/* ISO-10303-21 */\n", "\xef\xbb\xbf/* a; */ "}) {
        EXPECT_EQ(recognized(before + step), std::vector<std::string>{"STEP"}) << before;
        EXPECT_TRUE(nrb::io::read(before + whole, {}).splines.empty()) << before;
    }
    // as far from the start of its line as to have an S where IGES has the letter of a section
    const std::string far = std::string(73 - whole.find('S') - 1, ' ') + whole;
    EXPECT_TRUE(nrb::io::read(far, {}).splines.empty());
    EXPECT_TRUE(recognized("/* ISO-10303-21;").empty());
}

TEST(Formats, a_long_line_of_step_is_step) {
    std::string line = "ISO-10303-21;HEADER;ENDSEC;DATA;ENDSEC;END-ISO-10303-21;";
    line += std::string(72 - line.size(), ' ') + "S      1\n"; // where IGES has the letter of a section
    EXPECT_TRUE(nrb::io::read(line, {}).splines.empty());
}

nrb::Status refusal(const std::string &text, const nrb::io::ReadSettings &settings) {
    try {
        nrb::io::read(text, settings);
    } catch (const nrb::Error &error) {
        return error.status();
    }
    return nrb::Status::ok;
}

TEST(Formats, settings_are_checked_before_the_format) {
    EXPECT_EQ(refusal("solid", {.unit = -1}), nrb::Status::options);
    EXPECT_EQ(refusal("solid", {.max_bytes = 4}), nrb::Status::too_large);
    EXPECT_EQ(refusal("solid", {.max_bytes = 5}), nrb::Status::format);
    EXPECT_EQ(refusal(iges, {}), nrb::Status::truncated);
}

} // namespace

} // namespace formats_test
