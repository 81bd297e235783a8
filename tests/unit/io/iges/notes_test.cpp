// What does not become a spline is reported, entity by entity, and takes nothing else with it.
#include "support/iges_reading.h"

#include <algorithm>

namespace notes_test {

namespace {

using namespace iges_test;

TEST(IgesNotes, other_entities_in_the_order_of_the_directory) {
    IgesBuilder builder;
    builder.add(212, "1,2,3");
    builder.add(126, line_126);
    builder.add(5001, "1,2,3");
    builder.add(124, "1,0,0,0,0,1,0,0,0,0,1,0");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 1U);
    ASSERT_EQ(document.notes.size(), 3U);
    const int types[] = {212, 5001, 124};
    const int64_t lines[] = {1, 5, 7};
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(document.notes[i].entity_type, types[i]);
        EXPECT_EQ(document.notes[i].line, lines[i]);
        EXPECT_EQ(document.notes[i].reason, nrb::Status::unsupported);
    }
    EXPECT_EQ(document.notes[0].text.rfind("general note (212) at directory line 1: ", 0), 0U)
        << document.notes[0].text;
}

TEST(IgesNotes, splines_in_the_order_of_the_directory) {
    IgesBuilder builder;
    for (const char *label : {"C", "A", "B"}) {
        builder.add(126, line_126, {.label = label});
    }
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 3U);
    EXPECT_EQ(document.splines[0].name + document.splines[1].name + document.splines[2].name, "CAB");
}

// Three curves; eight columns (or more, if the text is longer) of a line of the file are replaced. Only the
// middle curve may suffer.
nrb::model::Note damaged(size_t line_in_section, char section, size_t column, const std::string &text) {
    IgesBuilder builder;
    for (int i = 0; i < 3; ++i) {
        builder.add(126, line_126);
    }
    std::vector<std::string> lines = builder.lines();
    for (std::string &line : lines) {
        if (line[72] == section && std::stoul(line.substr(73)) == line_in_section) {
            line.replace(column, std::max<size_t>(text.size(), 8), IgesBuilder::padded(text, 8));
        }
    }
    const nrb::model::Model document = read(IgesBuilder::join(lines));
    EXPECT_EQ(document.splines.size(), 2U) << text;
    EXPECT_EQ(document.notes.size(), 1U) << text;
    return document.notes.empty() ? nrb::model::Note{} : document.notes.front();
}

TEST(IgesNotes, damaged_directory_entries) {
    const struct {
        size_t line;
        size_t column;
        const char *text;
        const char *words;
    } cases[] = {
        {3, 0, "12x", "directory field 1 (entity type) is '12x'"},
        {3, 0, "128", "the two directory lines name different entity types, 128 and 126"},
        {4, 0, "128", "the two directory lines name different entity types, 126 and 128"},
        {3, 0, "-126", "entity type -126"},
        {3, 0, "1234567", "entity type 1234567"},
        {3, 8, "two", "directory field 2 (parameter data) is 'two'"},
        {3, 8, "0", "parameter data at line 0 where the section has lines 1 to 6"},
        {3, 8, "7", "parameter data at line 7"},
        {3, 8, "-1", "parameter data at line -1"},
        {3, 8, "1", "line 1 of the parameter section points back to '1', expected 3"},
        {3, 48, "x", "directory field 7 (transformation matrix)"},
        {4, 24, "99", "99 lines of parameter data from line 3 where the section has 6"},
        {4, 24, "1", "the record delimiter ';' is missing"},
        {4, 32, "?", "directory field 15 (form)"},
        {4, 64, "?", "directory field 19 (subscript)"},
    };
    for (const auto &[line, column, text, words] : cases) {
        const nrb::model::Note note = damaged(line, 'D', column, text);
        EXPECT_EQ(note.reason, nrb::Status::syntax) << text;
        EXPECT_EQ(note.line, 3);
        EXPECT_NE(note.text.find(words), std::string::npos) << note.text;
    }
}

TEST(IgesNotes, damaged_parameter_data) {
    EXPECT_NE(damaged(4, 'P', 64, "5").text.find("points back to '5', expected 3"), std::string::npos);
    EXPECT_NE(damaged(4, 'P', 64, "3x").text.find("points back to '3x'"), std::string::npos);
    EXPECT_NE(damaged(3, 'P', 0, "128,1,1,").text.find("the parameter data are those of an entity 128"),
              std::string::npos);
    EXPECT_NE(damaged(3, 'P', 0, "126,1,1,999H").text.find("a string of 999 characters"), std::string::npos);
}

std::vector<std::string> with_blank_field(char section, size_t column) {
    IgesBuilder builder;
    builder.add(126, line_126);
    builder.add(126, line_126);
    std::vector<std::string> lines = builder.lines();
    for (std::string &line : lines) {
        const bool second = section == 'D' && std::stoul(line.substr(73)) % 2 == 0;
        if (line[72] == section && (section == 'P' || second)) {
            line.replace(column, 8, 8, ' ');
        }
    }
    return lines;
}

TEST(IgesNotes, blank_back_pointers_or_line_counts_are_accepted) {
    EXPECT_EQ(read(IgesBuilder::join(with_blank_field('P', 64))).splines.size(), 2U);
    EXPECT_EQ(read(IgesBuilder::join(with_blank_field('D', 24))).splines.size(), 2U);
}

// Without back pointers nothing but the directory says whose a line is; it is given away once.
TEST(IgesNotes, parameter_data_belong_to_one_entity) {
    std::vector<std::string> lines = with_blank_field('P', 64);
    for (std::string &line : lines) {
        if (line[72] == 'D' && line.substr(73) == "0000003") {
            line.replace(8, 8, IgesBuilder::padded(1, 8));
        }
    }
    const nrb::model::Model document = read(IgesBuilder::join(lines));
    EXPECT_EQ(document.splines.size(), 1U);
    ASSERT_EQ(document.notes.size(), 1U);
    EXPECT_NE(document.notes.front().text.find("belongs to another entity too"), std::string::npos);
}

} // namespace

} // namespace notes_test
