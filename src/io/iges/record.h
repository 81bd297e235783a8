// SPDX-License-Identifier: MIT
// Free-format parameter data of IGES: parameters between delimiters, read one after the other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nrb::io::iges {

// Defined in the global section.
struct Delimiters {
    char parameter = ',';
    char record = ';';
};

// One record: the text up to its record delimiter, which it owns. Blanks around parameters are ignored;
// inside a Hollerith string (5Hab, c) delimiters and blanks are text.
class Record {
public:
    // Throws Status::syntax if a string is longer than the text, or if the record delimiter is missing. What
    // follows the record delimiter is a comment.
    Record(std::string text, Delimiters delimiters);

    // Number of parameters not read yet, including blank ones.
    [[nodiscard]] int64_t remaining() const noexcept { return count_ - taken_; }
    // Number of characters of the text.
    [[nodiscard]] int64_t length() const noexcept { return static_cast<int64_t>(text_.size()); }

    // The next parameter. A blank one, and any after the end of the record, has its default: 0, 0.0 or the
    // empty string. Throws Status::syntax naming `what` [`index`], the position in the record and the text.
    int64_t integer(const char *what, int64_t index = -1);
    double real(const char *what, int64_t index = -1);
    std::string_view string(const char *what);
    void skip(int64_t times);

    // Whether the next parameter is blank or absent.
    [[nodiscard]] bool next_is_blank() const;

private:
    struct Parameter {
        std::string_view text;
        bool is_string;
    };
    [[nodiscard]] Parameter scan(size_t &at) const;
    [[nodiscard]] Parameter scan_string(size_t &at, size_t length) const;
    [[nodiscard]] size_t skip_blanks(size_t at) const noexcept;
    Parameter take();
    [[noreturn]] void fail_value(const Parameter &parameter, const char *what, int64_t index,
                                 const char *expected) const;

    std::string text_;
    Delimiters delimiters_;
    size_t at_ = 0;
    int64_t taken_ = 0;
    int64_t count_ = 0;
};

} // namespace nrb::io::iges
