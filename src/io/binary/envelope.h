// SPDX-License-Identifier: MIT
// The binary form of handles: a header of 64 bytes, then a body of numbers. All numbers are little-endian.
//
//     0   8 bytes that reveal damage by text mode and 7-bit channels: 89 'N' 'U' 'R' 0d 0a 1a 0a
//     8   version of the form: major, minor (16 bits each)
//     12  kind of handle (32 bits)
//     16  size of the whole in bytes (64 bits)
//     24  crc64() of all other bytes
//     32  8 numbers whose meaning depends on the kind (32 bits each), 0 where there are none
//     64  the body
//
// Readers accept every version whose major number is not above their own. A later minor version only adds
// data after what they know.
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

// Each part of a body begins at a multiple of this many bytes.
inline constexpr size_t alignment = 64;

constexpr size_t aligned(size_t size) noexcept {
    return (size + alignment - 1) / alignment * alignment;
}

// Writes the header, then the body part by part, to memory of exactly the size of the whole.
class ByteWriter {
public:
    ByteWriter(Kind kind, const HeaderNumbers &numbers, std::span<unsigned char> out) noexcept;

    void put(uint64_t value) noexcept;
    void put(int64_t value) noexcept { put(static_cast<uint64_t>(value)); }
    void put(double value) noexcept;
    void put(std::span<const double> values) noexcept;
    void put(std::string_view text) noexcept;
    // Writes zeros up to the start of the next part.
    void align() noexcept;
    // The next `size` bytes of the body, for the caller to write.
    [[nodiscard]] std::span<unsigned char> room(size_t size) noexcept;
    [[nodiscard]] size_t place() const noexcept { return place_; }
    // Writes the size and the checksum to the header; to be called last.
    void finish() noexcept;

private:
    std::span<unsigned char> bytes_;
    size_t place_ = header_size;
};

// The contents of a header.
struct Header {
    Kind kind;
    uint16_t major, minor;
    HeaderNumbers numbers;
};
// Reads a header and checks it against the bytes. Throws Status::format for bytes that are not those of a
// handle, truncated for fewer bytes than the header says, syntax for more, version for a later major version,
// and checksum.
Header read_header(std::span<const unsigned char> bytes);
// Reads only the kind and the version, whatever the version, from at least the bytes of a header. Throws
// Status::format or truncated.
Header read_kind(std::span<const unsigned char> bytes);

// Reads a body from start to end.
class ByteReader {
public:
    // Throws what read_header() throws, and Status::format for another kind.
    ByteReader(std::span<const unsigned char> bytes, Kind kind);

    [[nodiscard]] const HeaderNumbers &numbers() const noexcept { return header_.numbers; }
    // Throws Status::truncated unless `count` more numbers of 64 bits are left. To be called before memory is
    // allocated for them.
    void need(uint64_t count) const;
    // A reader of the part that begins here, with `count` records of `numbers` numbers each. This reader
    // moves on to the next part. Throws Status::truncated.
    [[nodiscard]] ByteReader part(int64_t count, size_t numbers);
    [[nodiscard]] size_t left() const noexcept { return bytes_.size() - place_; }
    [[nodiscard]] uint64_t take();
    [[nodiscard]] int64_t take_integer() { return static_cast<int64_t>(take()); }
    [[nodiscard]] double take_double();
    // `count` numbers, in a vector with capacity for `spare` more.
    [[nodiscard]] std::vector<double> take_doubles(int64_t count, size_t spare = 0);
    // `count` integers of 64 bits.
    [[nodiscard]] std::vector<int64_t> take_integers(int64_t count);
    [[nodiscard]] std::string_view take_text(int64_t size);
    // The bytes of a handle within the body, which has a header of its own and begins here. Throws
    // Status::syntax unless `place`, where it begins according to the body, is here; truncated if it is not
    // complete.
    [[nodiscard]] std::span<const unsigned char> take_record(int64_t place);
    // Throws Status::syntax unless `place`, where a part begins according to the body, is here.
    void check_place(int64_t place, const char *part) const;
    void align() noexcept;
    // Throws Status::syntax for bytes after the last part, unless a later minor version wrote them.
    void end() const;

private:
    std::span<const unsigned char> bytes_;
    Header header_;
    size_t place_ = header_size;
};

} // namespace nrb::io
