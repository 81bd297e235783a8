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
#include <vector>

namespace nrb::io {

enum class Kind : uint32_t { spline = 1, list = 2, statistics = 3 };

inline constexpr size_t header_size = 64;
inline constexpr uint16_t major_version = 1, minor_version = 0;

using HeaderNumbers = std::array<int32_t, 8>;

// A body that grows.
class ByteWriter {
public:
    ByteWriter(Kind kind, const HeaderNumbers &numbers, size_t size);

    void put(uint64_t value);
    void put(int64_t value) { put(static_cast<uint64_t>(value)); }
    void put(double value);
    // Zeros up to a multiple of 64 bytes.
    void align();
    // Everything, with size and checksum.
    [[nodiscard]] std::vector<unsigned char> finish();

private:
    std::vector<unsigned char> bytes_;
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

// Reads a body from its start.
class ByteReader {
public:
    // Throws what read_header() does, and Status::format for another kind.
    ByteReader(std::span<const unsigned char> bytes, Kind kind);

    [[nodiscard]] const HeaderNumbers &numbers() const noexcept { return header_.numbers; }
    // Throws Status::truncated where there are not so many numbers of 64 bits; to be asked before room is made for them.
    void need(uint64_t count) const;
    [[nodiscard]] uint64_t take();
    [[nodiscard]] double take_double();
    void align() noexcept;

private:
    std::span<const unsigned char> bytes_;
    Header header_;
    size_t place_ = header_size;
};

} // namespace nrb::io
