// SPDX-License-Identifier: MIT
// Output of many numbers, in large blocks.
#pragma once

#include "io/file.h"

#include <bit>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>

namespace nrb::io {

// A buffer in front of a sink. Binary numbers are little-endian on every machine. Decimal numbers have the
// shortest digits that identify the value, with a point in every locale.
class Blocks {
public:
    explicit Blocks(const ByteSink &sink)
        : sink_(sink), buffer_(std::make_unique_for_overwrite<char[]>(block)) {}

    void text(std::string_view text);

    template <class Number>
    void bytes(Number value) {
        std::memcpy(room(sizeof value), &value, sizeof value);
        if constexpr (std::endian::native == std::endian::big) {
            turn_around(sizeof value);
        }
        used_ += sizeof value;
    }
    template <class... Numbers>
    requires(sizeof...(Numbers) > 1) void bytes(Numbers... values) { (bytes(values), ...); }

    template <class Number>
    void digits(Number value) {
        char *const start = room(most_digits);
        used_ += static_cast<size_t>(std::to_chars(start, start + most_digits, value).ptr - start);
    }
    // Decimal numbers, separated by blanks.
    template <class Number, class... Numbers>
    void row(Number first, Numbers... others) {
        digits(first);
        ((text(" "), digits(others)), ...);
    }

    // Passes the contents of the buffer to the sink. The destructor does not do so.
    void flush();

private:
    static constexpr size_t block = size_t{1} << 18, most_digits = 32;

    // Memory for `size` bytes in the buffer. Precondition: size <= block.
    char *room(size_t size) {
        if (block - used_ < size) {
            flush();
        }
        return buffer_.get() + used_;
    }
    void turn_around(size_t size) noexcept;

    const ByteSink &sink_;
    std::unique_ptr<char[]> buffer_; // not zeroed, which would take longer than writing a small file
    size_t used_ = 0;
};

// A source that gives what write(blocks) writes.
template <class Write>
ByteSource source_of(Write write) {
    return [write = std::move(write)](const ByteSink &sink) {
        Blocks out(sink);
        write(out);
        out.flush();
    };
}

// The number of bytes that a source gives.
int64_t size_of(const ByteSource &source);

} // namespace nrb::io
