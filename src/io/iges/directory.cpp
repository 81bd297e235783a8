// SPDX-License-Identifier: MIT
#include "io/iges/directory.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/text.h"

#include <algorithm>

namespace nrb::io::iges {
namespace {

constexpr size_t field_columns = 8;
constexpr size_t back_pointer_column = parameter_columns;

// Fields are numbered from 1 on each of the two lines.
std::string_view field_text(std::string_view line, size_t field) {
    return trim(line.substr((field - 1) * field_columns, field_columns));
}

// A blank field is 0.
int64_t field_integer(std::string_view line, size_t field, const char *what) {
    const std::string_view text = field_text(line, field);
    int64_t value = 0;
    if (!text.empty() && !parse_integer(text, value)) {
        fail(Status::syntax, "directory field %s is '%s', expected an integer", what, excerpt(text).c_str());
    }
    return value;
}

// The use flag, two of the digits of field 9 (blank status, subordinate, use, hierarchy): 05 means in the
// parameter plane of a surface.
bool in_parameter_plane(std::string_view line) {
    const std::string_view use = line.substr(8 * field_columns + 4, 2);
    return (use[0] == '0' || use[0] == ' ') && use[1] == '5';
}

void read_type(std::string_view first, std::string_view second, Entry &entry) {
    constexpr int64_t largest = 99'999;
    const int64_t type = field_integer(first, 1, "1 (entity type)");
    if (type < 0 || type > largest) {
        fail(Status::syntax, "entity type %lld where 0 to 99999 was expected", static_cast<long long>(type));
    }
    entry.type = static_cast<int>(type);
    const int64_t again = field_integer(second, 1, "11 (entity type)");
    if (again != type) {
        fail(Status::syntax, "the two directory lines name different entity types, %lld and %lld",
             static_cast<long long>(type), static_cast<long long>(again));
    }
}

void read_fields(std::string_view first, std::string_view second, Entry &entry) {
    read_type(first, second, entry);
    entry.data_line = field_integer(first, 2, "2 (parameter data)");
    entry.transform = field_integer(first, 7, "7 (transformation matrix)");
    entry.parameter_plane = in_parameter_plane(first);
    entry.data_count = field_integer(second, 4, "14 (parameter line count)");
    entry.form = field_integer(second, 5, "15 (form)");
    parse_integer(field_text(second, 3), entry.colour); // ignored if unreadable: no shape depends on it
    parse_integer(field_text(first, 5), entry.level);   // ignored in the same way
    entry.label = field_text(second, 8);
    entry.subscript = field_integer(second, 9, "19 (subscript)");
}

Entry read_entry(std::string_view first, std::string_view second, int64_t line) {
    Entry entry;
    entry.line = line;
    try {
        read_fields(first, second, entry);
    } catch (const Error &error) {
        entry.damage = error.what();
    }
    return entry;
}

// Columns 65-72: the entity to which a line of parameter data belongs.
std::string_view back_pointer_text(std::string_view line) {
    return trim(line.substr(back_pointer_column, field_columns));
}

// 0 if it is blank, -1 if it is not an integer.
int64_t back_pointer(std::string_view line) {
    const std::string_view text = back_pointer_text(line);
    int64_t value = 0;
    return text.empty() || parse_integer(text, value) ? value : -1;
}

} // namespace

Directory::Directory(const Lines &lines) {
    entries_.reserve(lines.size() / 2);
    constexpr int64_t work_of_an_entry = 1000;
    for (size_t i = 0; i + 1 < lines.size(); i += 2) {
        count_work(work_of_an_entry);
        entries_.push_back(read_entry(lines[i], lines[i + 1], static_cast<int64_t>(i) + 1));
    }
}

std::optional<size_t> Directory::find(int64_t pointer) const noexcept {
    if (pointer < 1 || pointer % 2 == 0 || pointer > 2 * std::ssize(entries_)) {
        return std::nullopt;
    }
    return static_cast<size_t>(pointer / 2);
}

// Where the line count is blank, the back pointers mark the extent of the data.
int64_t ParameterData::line_count(const Entry &entry) const {
    const int64_t left = std::ssize(lines_) - entry.data_line + 1;
    if (entry.data_count > 0) {
        if (entry.data_count > left) {
            fail(Status::syntax, "%lld lines of parameter data from line %lld where the section has %lld",
                 static_cast<long long>(entry.data_count), static_cast<long long>(entry.data_line),
                 static_cast<long long>(lines_.size()));
        }
        return entry.data_count;
    }
    int64_t count = 1;
    while (count < left &&
           back_pointer(lines_[static_cast<size_t>(entry.data_line + count - 1)]) == entry.line) {
        ++count;
    }
    return count;
}

void ParameterData::claim(int64_t line, const Entry &entry) {
    const auto index = static_cast<size_t>(line - 1);
    const int64_t owner = back_pointer(lines_[index]);
    if (owner != 0 && owner != entry.line) {
        fail(Status::syntax, "line %lld of the parameter section points back to '%s', expected %lld",
             static_cast<long long>(line), excerpt(back_pointer_text(lines_[index])).c_str(),
             static_cast<long long>(entry.line));
    }
    if (owners_[index] != 0 && owners_[index] != entry.line) {
        fail(Status::syntax, "line %lld of the parameter section belongs to another entity too",
             static_cast<long long>(line));
    }
    owners_[index] = entry.line;
}

Record ParameterData::take(const Entry &entry) {
    if (entry.data_line < 1 || entry.data_line > std::ssize(lines_)) {
        fail(Status::syntax, "parameter data at line %lld where the section has lines 1 to %lld",
             static_cast<long long>(entry.data_line), static_cast<long long>(lines_.size()));
    }
    const int64_t count = line_count(entry);
    std::string text;
    for (int64_t i = 0; i < count; ++i) {
        claim(entry.data_line + i, entry);
        text += lines_[static_cast<size_t>(entry.data_line + i - 1)].substr(0, parameter_columns);
    }
    Record record(std::move(text), delimiters_);
    const int64_t type = record.integer("entity type");
    if (type != entry.type) {
        fail(Status::syntax, "the parameter data are those of an entity %lld", static_cast<long long>(type));
    }
    return record;
}

} // namespace nrb::io::iges
