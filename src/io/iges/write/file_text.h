// SPDX-License-Identifier: MIT
// The sections of a file in the fixed-length form, while it is written.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nrb::io::iges {

// Status numbers of directory entries: blank status, subordinate, use, hierarchy.
inline constexpr std::string_view independent{"00000000"}, dependent{"00010000"}, property{"00010300"},
    lone_property{"00000300"}, in_parameters{"00010500"}, independent_in_parameters{"00000500"},
    definition{"00000200"}, definition_dependent{"00010200"};

// The name that readers give to an entity without a name.
std::string usual_name(int type, int64_t number);

// The fields of a directory entry.
struct Head {
    int type;
    int form = 0;
    std::string_view status = independent;
    int64_t colour = 0;    // minus a pointer to a definition
    int64_t transform = 0; // a pointer to a matrix
    int64_t level = 0;     // or minus a pointer to a list of them
};

// Parameters filled into lines of a given width. Numbers are not split, strings may continue on the next
// line.
class Parameters {
public:
    explicit Parameters(size_t columns) : columns_(columns) {}

    void begin(std::string after_line) { after_line_ = std::move(after_line); }
    void put(int64_t value);
    void put(int value) { put(int64_t{value}); }
    void put(double value);
    void put(std::string_view bytes); // an empty string is a default
    void put_all(std::span<const double> values) {
        for (const double value : values) {
            put(value);
        }
    }
    // Replaces the last parameter delimiter by the record delimiter, and fills up the line.
    void end();

    [[nodiscard]] int64_t lines() const noexcept { return lines_; }
    [[nodiscard]] const std::string &text() const noexcept { return text_; }

private:
    void token(std::string_view text);
    void delimiter();
    void end_line();

    size_t columns_;
    size_t column_ = 0;
    int64_t lines_ = 0;
    std::string after_line_; // the columns up to the sequence number
    std::string scratch_;
    std::string text_;
};

// Entities are identified by the number of the first of their two directory lines: 1, 3, 5...
class FileText {
public:
    // Reserves numbers for entities that others refer to before they are written. Every reserved entity has
    // to be written.
    int64_t reserve(int64_t count = 1);
    void begin(int64_t number, const Head &head);
    int64_t begin(const Head &head) {
        const int64_t number = reserve();
        begin(number, head);
        return number;
    }
    template <class... Values>
    void put(const Values &...values) {
        (data_.put(values), ...);
    }
    void put_all(std::span<const double> values) { data_.put_all(values); }
    // A list of pointers, preceded by its length.
    void put_list(std::span<const int64_t> pointers);
    void end();
    template <class... Values>
    int64_t add(const Head &head, const Values &...values) {
        const int64_t number = begin(head);
        put(values...);
        end();
        return number;
    }
    // Ends an entity whose name is given by a property.
    void end_named(std::string_view name);

    // The whole file. Throws Status::too_large if it has more lines than sequence numbers can count.
    [[nodiscard]] std::string file(const Parameters &global) const;

private:
    struct Entry {
        Head head{0};
        int64_t first_line = 0, lines = 0;
    };

    Parameters data_{64};
    std::vector<Entry> entries_;
    int64_t current_ = 0;
};

} // namespace nrb::io::iges
