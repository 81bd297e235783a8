// SPDX-License-Identifier: MIT
// The form that handles have as bytes: a header of 64 bytes, and a body of numbers, all with the lowest byte first.
//
//     0   8 bytes that show what text mode and 7-bit channels do to files: 89 'N' 'U' 'R' 0d 0a 1a 0a
//     8   version of the form: major, minor (16 bits each)
//     12  kind of handle (32 bits)
//     16  size of the whole in bytes (64 bits)
//     24  crc64() of all other bytes
//     32  8 numbers of the kind (32 bits each), 0 where there are none
//     64  the body
//
// Readers take all versions of their major and of those before it; what a later minor version adds stands behind what they
// know.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace nrb::io {

enum class Kind : uint32_t { spline = 1, list = 2, statistics = 3, face = 4, model = 5 };

inline constexpr size_t header_size = 64;
inline constexpr uint16_t major_version = 1, minor_version = 0;

using HeaderNumbers = std::array<int32_t, 8>;

// Each part of a body begins at a multiple of so many bytes.
inline constexpr size_t alignment = 64;

constexpr size_t aligned(size_t size) noexcept {
    return (size + alignment - 1) / alignment * alignment;
}

// Writes a whole, in the order of its parts, over memory of just its size.
class ByteWriter {
public:
    ByteWriter(Kind kind, const HeaderNumbers &numbers, std::span<unsigned char> out) noexcept;

    void put(uint64_t value) noexcept;
    void put(int64_t value) noexcept { put(static_cast<uint64_t>(value)); }
    void put(double value) noexcept;
    void put(std::span<const double> values) noexcept;
    void put(std::string_view text) noexcept;
    // Zeros up to the next part.
    void align() noexcept;
    // Memory of the body that somebody else writes.
    [[nodiscard]] std::span<unsigned char> room(size_t size) noexcept;
    [[nodiscard]] size_t place() const noexcept { return place_; }
    // The size and the checksum; to be called last.
    void finish() noexcept;

private:
    std::span<unsigned char> bytes_;
    size_t place_ = header_size;
};

// What a header says, after it was checked against the bytes.
struct Header {
    Kind kind;
    uint16_t major, minor;
    HeaderNumbers numbers;
};
// Throws Status::format for bytes that are no handle, truncated or syntax if there are fewer or more than the header says,
// version for one of a later major version, checksum.
Header read_header(std::span<const unsigned char> bytes);
// Kind and version alone, of any version, from the bytes of a header or more. Throws Status::format or truncated.
Header read_kind(std::span<const unsigned char> bytes);

// Reads a body from its start.
class ByteReader {
public:
    // Throws what read_header() does, and Status::format for another kind.
    ByteReader(std::span<const unsigned char> bytes, Kind kind);

    [[nodiscard]] const HeaderNumbers &numbers() const noexcept { return header_.numbers; }
    // Throws Status::truncated where there are not so many numbers of 64 bits; to be asked before room is made for them.
    void need(uint64_t count) const;
    // A reader at the part of `count` records of so many numbers each that begins here; this one passes over it. Throws
    // Status::truncated.
    [[nodiscard]] ByteReader part(int64_t count, size_t numbers);
    [[nodiscard]] size_t left() const noexcept { return bytes_.size() - place_; }
    [[nodiscard]] uint64_t take();
    [[nodiscard]] int64_t take_integer() { return static_cast<int64_t>(take()); }
    [[nodiscard]] double take_double();
    // So many numbers, in memory that has room for `spare` more.
    [[nodiscard]] std::vector<double> take_doubles(int64_t count, size_t spare = 0);
    // So many integers of 64 bits.
    [[nodiscard]] std::vector<int64_t> take_integers(int64_t count);
    [[nodiscard]] std::string_view take_text(int64_t size);
    // The bytes of a whole, with its own header, that stands at `place` in the body, where the last part ended.
    [[nodiscard]] std::span<const unsigned char> take_record(int64_t place);
    // Throws Status::syntax unless the part that begins here begins at `place`, as the bytes say.
    void check_place(int64_t place, const char *part) const;
    void align() noexcept;
    // Throws Status::syntax for bytes behind the last part, but for those of a later minor version.
    void end() const;

private:
    std::span<const unsigned char> bytes_;
    Header header_;
    size_t place_ = header_size;
};

} // namespace nrb::io
