// SPDX-License-Identifier: MIT
#include "io/iges/write/file_text.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/lines.h"
#include "io/iges/text.h"
#include "io/iges/types.h"
#include "io/written/real_text.h"
#include "io/written/spline_facts.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace nrb::io::iges {
namespace {

constexpr int64_t work_of_a_line = 64;
constexpr int name_form = 15;
constexpr std::string_view start_section = "Written by libnurbs.";

// Right-aligned in a field.
void append_field(int64_t value, size_t width, std::string &text) {
    char digits[24];
    const auto size = static_cast<size_t>(std::to_chars(digits, digits + sizeof digits, value).ptr - digits);
    text.append(width > size ? width - size : 0, ' ');
    text.append(digits, size);
}

void append_sequence(char section, int64_t number, std::string &text) {
    text += section;
    append_field(number, 7, text);
    text += '\n';
}

void append_fields(std::span<const int64_t> values, std::string &text) {
    for (const int64_t value : values) {
        append_field(value, 8, text);
    }
}

} // namespace

std::string usual_name(int type, int64_t number) {
    return std::to_string(type) + "#" + std::to_string(number);
}

void Parameters::end_line() {
    text_.append(columns_ - column_, ' ');
    text_ += after_line_;
    append_field(++lines_, 7, text_);
    text_ += '\n';
    column_ = 0;
    count_work(work_of_a_line);
}

void Parameters::delimiter() {
    if (column_ == columns_) {
        end_line();
    }
    text_ += ',';
    ++column_;
}

// Puts a token and its delimiter on the same line.
void Parameters::token(std::string_view text) {
    if (column_ + text.size() + 1 > columns_) {
        end_line();
    }
    text_ += text;
    column_ += text.size();
    delimiter();
}

void Parameters::put(int64_t value) {
    char digits[24];
    token({digits, static_cast<size_t>(std::to_chars(digits, digits + sizeof digits, value).ptr - digits)});
}

void Parameters::put(double value) {
    scratch_.clear();
    append_real(value, scratch_);
    token(scratch_);
}

// The length stays on one line with the first character.
void Parameters::put(std::string_view bytes) {
    if (bytes.empty()) {
        return delimiter();
    }
    const std::string length = std::to_string(bytes.size()) + "H";
    if (column_ + length.size() + 1 > columns_) {
        end_line();
    }
    text_ += length;
    column_ += length.size();
    while (!bytes.empty()) {
        if (column_ == columns_) {
            end_line();
        }
        const size_t fits = std::min(columns_ - column_, bytes.size());
        text_ += bytes.substr(0, fits);
        column_ += fits;
        bytes.remove_prefix(fits);
    }
    delimiter();
}

void Parameters::end() {
    text_.back() = ';';
    end_line();
}

int64_t FileText::reserve(int64_t count) {
    const int64_t number = 2 * std::ssize(entries_) + 1;
    entries_.resize(entries_.size() + static_cast<size_t>(count));
    return number;
}

void FileText::begin(int64_t number, const Head &head) {
    std::string after_line;
    append_field(number, line_columns - data_columns, after_line);
    data_.begin(after_line + 'P');
    Entry &entry = entries_[static_cast<size_t>(number / 2)];
    entry = {head, data_.lines() + 1, 0};
    current_ = number;
    put(head.type);
}

void FileText::put_list(std::span<const int64_t> pointers) {
    put(std::ssize(pointers));
    for (const int64_t pointer : pointers) {
        put(pointer);
    }
}

void FileText::end() {
    data_.end();
    Entry &entry = entries_[static_cast<size_t>(current_ / 2)];
    entry.lines = data_.lines() - entry.first_line + 1;
}

// No associativities, and one property. If readers derive the same name from type and number, no property is
// needed.
void FileText::end_named(std::string_view name) {
    const int type = entries_[static_cast<size_t>(current_ / 2)].head.type;
    const std::string stated = printable(stated_name(name, usual_name(type, current_)));
    if (stated.empty()) {
        return end();
    }
    const int64_t number = reserve();
    put(0, 1, number);
    end();
    begin(number, {property_type, name_form, property});
    put(1, std::string_view(stated));
    end();
}

std::string FileText::file(const Parameters &global) const {
    const int64_t directory_lines = 2 * std::ssize(entries_);
    if (std::max(directory_lines, data_.lines()) >= sequence_limit) {
        fail(Status::too_large,
             "the file has %lld lines of parameters and %lld of its directory, IGES counts to %lld",
             static_cast<long long>(data_.lines()), static_cast<long long>(directory_lines),
             static_cast<long long>(sequence_limit - 1));
    }
    std::string text(start_section);
    text.reserve(data_.text().size() + global.text().size() +
                 (static_cast<size_t>(directory_lines) + 2) * (line_columns + 1));
    text.append(data_columns - text.size(), ' ');
    append_sequence('S', 1, text);
    text += global.text();
    for (size_t i = 0; i < entries_.size(); ++i) {
        const auto &[head, first_line, lines] = entries_[i];
        const auto number = static_cast<int64_t>(2 * i + 1);
        append_fields(std::array<int64_t, 8>{head.type, first_line, 0, 0, head.level, 0, head.transform, 0},
                      text);
        text += head.status;
        append_sequence('D', number, text);
        append_fields(std::array<int64_t, 5>{head.type, 0, head.colour, lines, head.form}, text);
        text.append(3 * 8, ' ');
        append_field(0, 8, text);
        append_sequence('D', number + 1, text);
        count_work(2 * work_of_a_line);
    }
    text += data_.text();
    const std::pair<char, int64_t> counts[] = {
        {'S', 1}, {'G', global.lines()}, {'D', directory_lines}, {'P', data_.lines()}};
    for (const auto &[section, count] : counts) {
        text += section;
        append_field(count, 7, text);
    }
    text.append(5 * 8, ' ');
    append_sequence('T', 1, text);
    return text;
}

} // namespace nrb::io::iges
