// SPDX-License-Identifier: MIT
// Files of many numbers, written in large blocks.
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

// A buffer before a sink. Numbers as bytes have the lowest byte first, on every machine; as digits they have as many as name
// them, with a point in every locale.
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
    // With blanks between them.
    template <class Number, class... Numbers>
    void row(Number first, Numbers... others) {
        digits(first);
        ((text(" "), digits(others)), ...);
    }

    // What is in the buffer goes on. Nothing does by itself when this is destroyed.
    void flush();

private:
    static constexpr size_t block = size_t{1} << 18, most_digits = 32;

    // Precondition: no more than a block.
    char *room(size_t size) {
        if (block - used_ < size) {
            flush();
        }
        return buffer_.get() + used_;
    }
    void turn_around(size_t size) noexcept;

    const ByteSink &sink_;
    std::unique_ptr<char[]> buffer_; // not filled with zeros, which would take longer than small files
    size_t used_ = 0;
};

// What write(blocks) writes, as a source.
template <class Write>
ByteSource source_of(Write write) {
    return [write = std::move(write)](const ByteSink &sink) {
        Blocks out(sink);
        write(out);
        out.flush();
    };
}

// How many bytes a source gives.
int64_t size_of(const ByteSource &source);

} // namespace nrb::io
