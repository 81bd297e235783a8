// Lines, sections and their counts; whole-file failures.
#include "support/iges_reading.h"

namespace lines_test {

namespace {

using namespace iges_test;

IgesBuilder one_line() {
    IgesBuilder builder;
    builder.add(126, line_126);
    return builder;
}

// Line number `number` of the file, from 1, replaced.
std::string with_line(size_t number, const std::string &line) {
    std::vector<std::string> lines = one_line().lines();
    lines.at(number - 1) = line;
    return IgesBuilder::join(lines);
}

TEST(IgesLines, every_line_end) {
    const IgesBuilder builder = one_line();
    const std::vector<double> expected = {1, 2, 3, 4, 6, 8};
    std::string stripped = builder.text();
    stripped.pop_back();
    for (const std::string &text : {builder.text("\n"), builder.text("\r\n"), stripped,
                                    builder.text() + "\n\n", builder.text("\r\n") + "\x1a",
                                    builder.text("  \n"), builder.text("\r"), "\xef\xbb\xbf" + builder.text(),
                                    "\n  \n" + builder.text(), builder.text() + std::string(100, '\0')}) {
        EXPECT_EQ(points_of(*only_spline(read(text))), expected);
    }
}

TEST(IgesLines, trailing_blanks_may_be_stripped) {
    std::vector<std::string> lines = one_line().lines();
    lines.back().replace(73, 7, "1"); // a short sequence number, left aligned
    for (std::string &line : lines) {
        line.erase(line.find_last_not_of(' ') + 1);
    }
    EXPECT_NE(only_spline(read(IgesBuilder::join(lines))), nullptr);
}

TEST(IgesLines, sequence_numbers_padded_by_blanks_or_left_out) {
    std::vector<std::string> lines = one_line().lines();
    for (std::string &line : lines) {
        const size_t digit = line.find_first_not_of('0', 73);
        line.replace(73, digit - 73, std::string(digit - 73, ' '));
    }
    EXPECT_NE(only_spline(read(IgesBuilder::join(lines))), nullptr);
    for (std::string &line : lines) {
        line.resize(73);
    }
    EXPECT_NE(only_spline(read(IgesBuilder::join(lines))), nullptr);
}

TEST(IgesLines, empty_directory_is_a_file_without_entities) {
    const nrb::model::Model document = read(IgesBuilder());
    EXPECT_TRUE(document.splines.empty());
    EXPECT_TRUE(document.notes.empty());
}

TEST(IgesLines, other_formats_are_named) {
    EXPECT_EQ(failure_of("").status, nrb::Status::format);
    EXPECT_EQ(failure_of("solid cube\nfacet normal\n").status, nrb::Status::format);
    const Failure compressed = failure_of(with_line(1, IgesBuilder::section_line("", 'C', 1)));
    EXPECT_EQ(compressed.status, nrb::Status::format);
    EXPECT_NE(compressed.text.find("compressed"), std::string::npos);
    EXPECT_EQ(failure_of(std::string(10000, '\0')).status, nrb::Status::format);
    EXPECT_EQ(failure_of(std::string(10000, '\xff')).status, nrb::Status::format);
}

TEST(IgesLines, broken_lines_are_named) {
    const std::vector<std::string> lines = one_line().lines();
    const std::string wrong_letter = lines[3].substr(0, 72) + "X0000001";
    const std::string wrong_sequence = lines[3].substr(0, 72) + "D0000007";
    for (const std::string &line : {wrong_letter, wrong_sequence, std::string("short"), std::string(),
                                    lines[3] + "more", IgesBuilder::section_line("", 'S', 2)}) {
        const Failure failure = failure_of(with_line(4, line));
        EXPECT_EQ(failure.status, nrb::Status::syntax) << line;
        EXPECT_NE(failure.text.find("line 4:"), std::string::npos) << failure.text;
    }
}

TEST(IgesLines, text_after_the_end) {
    const std::vector<std::string> lines = one_line().lines();
    const Failure failure = failure_of(one_line().text() + "\nrubbish\n");
    EXPECT_EQ(failure.status, nrb::Status::syntax);
    EXPECT_NE(failure.text.find("line " + std::to_string(lines.size() + 2)), std::string::npos)
        << failure.text;
}

TEST(IgesLines, missing_sections) {
    std::vector<std::string> lines = one_line().lines();
    lines.pop_back();
    EXPECT_EQ(failure_of(IgesBuilder::join(lines)).status, nrb::Status::truncated);
    lines = one_line().lines();
    std::erase_if(lines, [](const std::string &line) { return line[72] == 'G'; });
    EXPECT_EQ(failure_of(IgesBuilder::join(lines)).status, nrb::Status::truncated);
    lines = one_line().lines();
    std::erase_if(lines, [](const std::string &line) { return line[72] == 'P'; });
    EXPECT_EQ(failure_of(IgesBuilder::join(lines)).status, nrb::Status::truncated);
}

TEST(IgesLines, counts_of_the_terminate_section) {
    const size_t last = one_line().lines().size();
    const auto with_counts = [&](const std::string &counts) {
        return failure_of(with_line(last, IgesBuilder::section_line(counts, 'T', 1))).status;
    };
    EXPECT_EQ(with_counts(""), nrb::Status::ok);
    EXPECT_EQ(with_counts("S      1G      2D      2P      2"), nrb::Status::ok);
    EXPECT_EQ(with_counts("S      1G      2D      4P      2"), nrb::Status::truncated);
    EXPECT_EQ(with_counts("S      1G      2D      2P      1"), nrb::Status::syntax);
    EXPECT_EQ(with_counts("S      1G      2D      2P      x"), nrb::Status::syntax);
    EXPECT_EQ(with_counts("S      1X      2D      2P      2"), nrb::Status::syntax);
}

TEST(IgesLines, an_entity_takes_two_directory_lines) {
    std::vector<std::string> lines = one_line().lines();
    lines.erase(lines.begin() + 4);
    lines.back() = IgesBuilder::section_line("", 'T', 1);
    EXPECT_EQ(failure_of(IgesBuilder::join(lines)).status, nrb::Status::truncated);
}

// Whatever is cut off: before column 73 of the first line it is no IGES, later it is a file without its end,
// and once the terminate line's letter is there it is whole.
TEST(IgesLines, every_truncation_is_noticed) {
    const std::string text = one_line().text();
    const size_t whole = text.rfind('T') + 1;
    for (size_t length = 0; length < text.size(); ++length) {
        const nrb::Status expected =
            length < 73 ? nrb::Status::format : (length < whole ? nrb::Status::truncated : nrb::Status::ok);
        const Failure failure = failure_of(text.substr(0, length));
        // Inside the last sequence number a part of "0000001" may read as 0.
        if (length > whole && failure.status == nrb::Status::truncated) {
            continue;
        }
        ASSERT_EQ(failure.status, expected) << "cut at " << length << ": " << failure.text;
    }
}

} // namespace

} // namespace lines_test
