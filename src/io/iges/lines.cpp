// SPDX-License-Identifier: MIT
#include "io/iges/lines.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/text.h"

#include <algorithm>

namespace nrb::io::iges {
namespace {

constexpr std::string_view section_letters = "SGDPT";

struct FileLine {
    std::string_view text;
    int64_t number;  // in the file, from 1
    bool terminated; // false only for a last line without a line end
};

// Takes the next line off `rest`, without its line end, which is LF, CR LF or CR.
FileLine take_line(std::string_view &rest, int64_t number) noexcept {
    const size_t feed = rest.find('\n'); // faster than find_first_of(), which examines each character
    const size_t end = std::min(feed, rest.substr(0, feed).find('\r'));
    const bool terminated = end != std::string_view::npos;
    const std::string_view text(rest.data(), std::min(end, rest.size()));
    rest.remove_prefix(terminated ? end : rest.size());
    if (terminated) {
        rest.remove_prefix(rest.starts_with("\r\n") ? 2 : 1);
    }
    return {text, number, terminated};
}

// Text files of DOS may end with a Control-Z; some programs pad the last block with zeros.
bool blank(std::string_view text) noexcept {
    constexpr std::string_view nothing(" \t\r\n\x1a\0", 6);
    return text.find_first_not_of(nothing) == std::string_view::npos;
}

// Removes what editors and mail programs put before the first line; returns the number of lines removed.
int64_t take_preamble(std::string_view &rest) noexcept {
    constexpr std::string_view byte_order_mark("\xef\xbb\xbf");
    if (rest.starts_with(byte_order_mark)) {
        rest.remove_prefix(byte_order_mark.size());
    }
    int64_t lines = 0;
    for (std::string_view ahead = rest; !ahead.empty() && blank(take_line(ahead, 0).text); ++lines) {
        rest = ahead;
    }
    return lines;
}

char section_letter(std::string_view text) noexcept {
    return text.size() > data_columns ? text[data_columns] : ' ';
}

[[noreturn]] void fail_truncated(const FileLine &line) {
    fail(Status::truncated, "line %lld: the file ends inside this line", static_cast<long long>(line.number));
}

// Index into section_letters.
size_t section_of(const FileLine &line) {
    const char letter = section_letter(line.text);
    const size_t section = section_letters.find(letter);
    if (section != std::string_view::npos) {
        return section;
    }
    if (!line.terminated && line.text.size() <= data_columns) {
        fail_truncated(line);
    }
    fail(Status::syntax,
         "line %lld: column 73 holds '%s' where a section letter S, G, D, P or T was expected",
         static_cast<long long>(line.number), excerpt(std::string_view(&letter, 1)).c_str());
}

// Columns 74-80 count the lines of the section; a missing line would shift every pointer after it. A blank
// number counts as correct.
void check_sequence(const FileLine &line, int64_t expected) {
    const std::string_view field = trim(line.text.substr(data_columns + 1, line_columns - data_columns - 1));
    int64_t sequence = 0;
    if (field.empty() || (parse_integer(field, sequence) && sequence == expected % sequence_limit)) {
        return;
    }
    if (!line.terminated && line.text.size() < line_columns) {
        fail_truncated(line);
    }
    fail(Status::syntax, "line %lld: sequence number '%s' where %lld was expected",
         static_cast<long long>(line.number), excerpt(field).c_str(), static_cast<long long>(expected));
}

void check_width(const FileLine &line) {
    if (line.text.size() > line_columns && !blank(line.text.substr(line_columns))) {
        fail(Status::syntax, "line %lld: %lld columns where 80 are the most",
             static_cast<long long>(line.number), static_cast<long long>(line.text.size()));
    }
}

// Only blank lines may follow the terminate section.
void check_rest(std::string_view rest, int64_t number) {
    while (!rest.empty()) {
        const FileLine line = take_line(rest, ++number);
        if (!blank(line.text)) {
            fail(Status::syntax, "line %lld: text after the terminate section",
                 static_cast<long long>(number));
        }
    }
}

void check_stated(std::string_view stated, char letter, const Lines &lines) {
    int64_t count = 0;
    const auto present = static_cast<int64_t>(lines.size());
    const std::string_view field = stated.empty() ? stated : trim(stated.substr(1));
    if (field.empty()) {
        return;
    }
    if (stated[0] != letter || !parse_integer(field, count)) {
        fail(Status::syntax, "terminate section: '%s' where the number of lines of section %c was expected",
             excerpt(stated).c_str(), letter);
    }
    if (count != present % sequence_limit) {
        fail(count > present ? Status::truncated : Status::syntax,
             "section %c has %lld lines, the terminate section says %lld", letter,
             static_cast<long long>(present), static_cast<long long>(count));
    }
}

// "S0000001G0000004D0000010P0000045": the number of lines of each section.
void check_counts(const Sections &sections) {
    const std::string_view text = sections.terminate.front();
    check_stated(text.substr(0, 8), 'S', sections.start);
    check_stated(text.substr(8, 8), 'G', sections.global);
    check_stated(text.substr(16, 8), 'D', sections.directory);
    check_stated(text.substr(24, 8), 'P', sections.parameter);
}

void check_complete(const Sections &sections) {
    if (sections.terminate.empty()) {
        fail(Status::truncated, "the file ends without its terminate section");
    }
    if (sections.global.empty()) {
        fail(Status::truncated, "the global section is missing");
    }
    check_counts(sections);
    if (sections.directory.size() % 2 != 0) {
        fail(Status::truncated,
             "the directory section has %lld lines, an odd number, where each entity takes two",
             static_cast<long long>(sections.directory.size()));
    }
}

} // namespace

std::string_view first_line(std::span<const char> bytes) noexcept {
    std::string_view rest(bytes.data(), bytes.size());
    take_preamble(rest);
    return take_line(rest, 1).text;
}

bool begins_iges(std::span<const char> bytes) noexcept {
    const char letter = section_letter(first_line(bytes));
    return letter == 'S' || letter == 'G';
}

bool begins_compressed(std::span<const char> bytes) noexcept {
    return section_letter(first_line(bytes)) == 'C';
}

constexpr int64_t work_of_a_line = 100;

Sections split_sections(std::span<const char> bytes) {
    Sections sections;
    Lines *const in_order[] = {&sections.start, &sections.global, &sections.directory, &sections.parameter,
                               &sections.terminate};
    std::string_view rest(bytes.data(), bytes.size());
    const int64_t skipped = take_preamble(rest);
    size_t current = 0;
    for (int64_t number = skipped + 1; !rest.empty() && sections.terminate.empty(); ++number) {
        count_work(work_of_a_line);
        const FileLine line = take_line(rest, number);
        const size_t section = section_of(line);
        if (section < current) {
            fail(Status::syntax, "line %lld: a line of section %c after section %c",
                 static_cast<long long>(number), section_letters[section], section_letters[current]);
        }
        current = section;
        in_order[section]->push_back(line.text.substr(0, line_columns));
        check_sequence(line, static_cast<int64_t>(in_order[section]->size()));
        check_width(line);
        if (!sections.terminate.empty()) {
            check_rest(rest, number);
        }
    }
    check_complete(sections);
    return sections;
}

} // namespace nrb::io::iges
