// SPDX-License-Identifier: MIT
// The directory section of an IGES file, and the parameter data that its entries point to.
#pragma once

#include "io/iges/lines.h"
#include "io/iges/record.h"

#include <optional>
#include <string>
#include <vector>

namespace nrb::io::iges {

// A directory entry: two lines of ten fields of eight columns each.
struct Entry {
    int type = 0;
    int64_t line = 0; // sequence number of its first line, by which pointers refer to it
    int64_t data_line = 0;
    int64_t data_count = 0;
    int64_t transform = 0; // pointer to a transformation matrix; 0: none
    bool parameter_plane = false;
    int64_t form = 0;
    int64_t colour = 0; // one of eight colours, or minus a pointer to a definition (314); 0: none
    int64_t level = 0;  // a level, or minus a pointer to a property that lists several; 0: none
    std::string_view label;
    int64_t subscript = 0;
    std::string damage; // what is wrong with these two lines; empty: nothing
};

class Directory {
public:
    // An unreadable field damages its entry, never the file.
    explicit Directory(const Lines &lines);

    [[nodiscard]] const std::vector<Entry> &entries() const noexcept { return entries_; }
    // Index of the entry that a pointer refers to, if there is one.
    [[nodiscard]] std::optional<size_t> find(int64_t pointer) const noexcept;

private:
    std::vector<Entry> entries_;
};

// The parameter section. Each of its lines belongs to one entry, which keeps the total amount read linear,
// whatever the pointers are; how often an entry is read is for its reader to limit.
class ParameterData {
public:
    ParameterData(const Lines &lines, Delimiters delimiters)
        : lines_(lines), delimiters_(delimiters), owners_(lines.size(), 0) {}

    // The record of an entry, positioned after the entity type. Throws Status::syntax if the pointer, the
    // back pointers, the type or the delimiters are wrong.
    Record take(const Entry &entry);

private:
    void claim(int64_t line, const Entry &entry);
    [[nodiscard]] int64_t line_count(const Entry &entry) const;

    const Lines &lines_;
    Delimiters delimiters_;
    std::vector<int64_t> owners_; // directory lines; 0: not claimed yet
};

} // namespace nrb::io::iges
