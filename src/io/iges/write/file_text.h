// SPDX-License-Identifier: MIT
// The sections of a file in the fixed-length form as they are written.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nrb::io::iges {

// Status numbers of directory entries: blank, subordinate, use, hierarchy.
inline constexpr std::string_view independent{"00000000"}, dependent{"00010000"}, property{"00010300"},
    lone_property{"00000300"}, in_parameters{"00010500"}, independent_in_parameters{"00000500"},
    definition{"00000200"}, definition_dependent{"00010200"};

// What readers call an entity without a name.
std::string usual_name(int type, int64_t number);

// What a directory entry says of its entity.
struct Head {
    int type;
    int form = 0;
    std::string_view status = independent;
    int64_t colour = 0;    // minus a pointer to a definition
    int64_t transform = 0; // a pointer to a matrix
    int64_t level = 0;     // or minus a pointer to a list of them
};

// Parameters filled into lines of a width. Numbers stay whole, strings may go on in the next line.
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
    // The delimiter of the record in place of the last one of a parameter, and the rest of the line.
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
    std::string after_line_; // up to the sequence number
    std::string scratch_;
    std::string text_;
};

// Entities are named by the numbers of the first of their two directory lines: 1, 3, 5...
class FileText {
public:
    // For entities that others name before they are written. Every one that is reserved has to be written.
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
    // A list of pointers, with the length before it.
    void put_list(std::span<const int64_t> pointers);
    void end();
    template <class... Values>
    int64_t add(const Head &head, const Values &...values) {
        const int64_t number = begin(head);
        put(values...);
        end();
        return number;
    }
    // end() of an entity to which a property gives the name.
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
