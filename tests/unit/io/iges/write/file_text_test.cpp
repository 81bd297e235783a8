// The lines of a file: columns, numbers of lines, and what they are filled with.
#include "base/error.h"
#include "io/iges/write/file_text.h"
#include "io/iges/write/write_global.h"
#include "support/iges_reading.h"

#include <cmath>
#include <map>
#include <numbers>

namespace iges_file_text_test {
namespace {

using namespace nrb;
using namespace nrb::io::iges;

std::vector<std::string> lines_of(const std::string &text) {
    std::vector<std::string> lines;
    for (size_t at = 0; at < text.size();) {
        const size_t end = text.find('\n', at);
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

Parameters global() {
    return write_global({"", 0.001, 1e-6, 10});
}

std::vector<std::string> section(const FileText &text, char letter) {
    std::vector<std::string> found;
    for (const std::string &line : lines_of(text.file(global()))) {
        if (line[72] == letter) {
            found.push_back(line);
        }
    }
    return found;
}

TEST(IgesFileText, EveryLineHas80ColumnsAndItsNumber) {
    FileText text;
    for (int i = 0; i < 30; ++i) {
        const int64_t number = text.begin({110, 0, independent});
        for (int k = 0; k < i; ++k) {
            text.put(std::numbers::pi * k);
        }
        text.end();
        EXPECT_EQ(number, 2 * i + 1);
    }
    std::map<char, int64_t> counts;
    std::string terminate;
    for (const std::string &line : lines_of(text.file(global()))) {
        ASSERT_EQ(line.size(), 80U);
        EXPECT_EQ(std::stoll(line.substr(73)), ++counts[line[72]]);
        terminate = line;
    }
    char expected[81];
    std::snprintf(expected, sizeof expected, "S%7dG%7dD%7dP%7d", 1, static_cast<int>(counts['G']), 60,
                  static_cast<int>(counts['P']));
    EXPECT_EQ(terminate.substr(0, 32), expected);
    EXPECT_EQ(terminate.substr(72), "T      1");
}

TEST(IgesFileText, DirectoryEntriesPointToTheirLines) {
    FileText text;
    const int64_t later = text.reserve();
    const int64_t first = text.add({123, 0, definition_dependent}, 1.0, 0.0, 0.0);
    text.begin(later, {510, 1, in_parameters, -7, 9});
    text.put(first, std::string_view("x"));
    text.end();
    const std::vector<std::string> directory = section(text, 'D'), parameters = section(text, 'P');
    ASSERT_EQ(directory.size(), 4U);
    EXPECT_EQ(directory[0],
              "     510       2       0       0       0       0       9       000010500D      1");
    EXPECT_EQ(directory[1],
              "     510       0      -7       1       1                               0D      2");
    EXPECT_EQ(directory[2],
              "     123       1       0       0       0       0       0       000010200D      3");
    ASSERT_EQ(parameters.size(), 2U);
    EXPECT_EQ(parameters[0], "123,1.,0.,0.;" + std::string(51, ' ') + "       3P      1");
    EXPECT_EQ(parameters[1], "510,3,1Hx;" + std::string(54, ' ') + "       1P      2");
}

// Each number stays on one line, and each line takes what fits.
TEST(IgesFileText, LinesAreFilledWithWholeNumbers) {
    FileText text;
    text.begin({126});
    for (int i = 1; i < 400; ++i) {
        text.put(std::sin(i) * std::pow(10, i % 40 - 20));
    }
    text.end();
    const std::vector<std::string> lines = section(text, 'P');
    for (size_t i = 0; i + 1 < lines.size(); ++i) {
        const std::string data = lines[i].substr(0, 64), next = lines[i + 1].substr(0, 64);
        const size_t used = data.find_last_not_of(' ') + 1;
        EXPECT_EQ(data[used - 1], ',');
        EXPECT_GT(used + next.find_first_of(",;") + 1, 64U);
    }
}

TEST(IgesFileText, StringsGoOnInTheNextLine) {
    const std::string name(200, 'n');
    for (size_t before = 0; before < 70; ++before) {
        FileText text;
        text.add({406, 15}, std::string_view(std::string(before + 1, 'b')), std::string_view(name));
        std::string joined;
        for (const std::string &line : section(text, 'P')) {
            joined += line.substr(0, 64);
        }
        EXPECT_NE(joined.find("200H" + name + ";"), std::string::npos) << before;
    }
}

TEST(IgesFileText, RealsHaveAPointAndAllDigits) {
    FileText text;
    text.add({110}, 1.0, -0.0, 1e300, 1e-7, 1.0 / 3, 5e-324);
    EXPECT_EQ(section(text, 'P')[0].substr(0, 64),
              "110,1.,-0.,1.E+300,1.E-07,0.3333333333333333,5.E-324;           ");
    FileText other;
    EXPECT_THROW(other.add({110}, HUGE_VAL), Error);
}

TEST(IgesFileText, UnitsAreStatedByNumberOrByScale) {
    const auto joined = [](double metres) {
        std::string all;
        for (const std::string &line : lines_of(write_global({"", metres, 1e-6, 0}).text())) {
            all += line.substr(0, 72);
        }
        return all;
    };
    EXPECT_NE(joined(0.0254).find(",1.,1,4HINCH,"), std::string::npos);
    EXPECT_NE(joined(0.001).find(",1.,2,2HMM,"), std::string::npos);
    EXPECT_NE(joined(1).find(",1.,6,1HM,"), std::string::npos);
    for (const double metres : {0.123, 0.9144, 1e-10, 7e3, 1.0 / 3}) {
        EXPECT_EQ(joined(metres).find(",1.,"), std::string::npos) << metres;
    }
}

} // namespace
} // namespace iges_file_text_test
