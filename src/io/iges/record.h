// SPDX-License-Identifier: MIT
// Free-format data of IGES: parameters between delimiters, read one after the other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nrb::io::iges {

// Set by the global section.
struct Delimiters {
    char parameter = ',';
    char record = ';';
};

// One record, owned: the text up to its record delimiter. Blanks around parameters do not count; inside a
// Hollerith string (5Hab, c) delimiters and blanks are text.
class Record {
public:
    // Throws Status::syntax if a string is longer than the text or the record delimiter is missing. What
    // follows the record delimiter is a comment.
    Record(std::string text, Delimiters delimiters);

    // Parameters not read yet, blank ones included.
    [[nodiscard]] int64_t remaining() const noexcept { return count_ - taken_; }
    // Characters of all of it.
    [[nodiscard]] int64_t length() const noexcept { return static_cast<int64_t>(text_.size()); }

    // The next parameter. A blank one, and one after the end of the record, has its default: 0, 0.0 or the
    // empty string. Throws Status::syntax naming `what` [`index`], the place in the record and the text.
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
