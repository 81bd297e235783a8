// SPDX-License-Identifier: MIT
#include "io/binary/envelope.h"

#include "base/error.h"
#include "io/binary/crc64.h"

#include <algorithm>
#include <bit>

namespace nrb::io {

namespace {

constexpr std::array<unsigned char, 8> magic = {0x89, 'N', 'U', 'R', 0x0d, 0x0a, 0x1a, 0x0a};
constexpr size_t at_version = 8, at_kind = 12, at_size = 16, at_checksum = 24, at_numbers = 32;

void put_number(uint64_t value, size_t size, unsigned char *out) noexcept {
    for (size_t i = 0; i < size; ++i) {
        out[i] = static_cast<unsigned char>(value >> (8 * i));
    }
}

uint64_t number_at(std::span<const unsigned char> bytes, size_t place, size_t size) noexcept {
    uint64_t value = 0;
    for (size_t i = 0; i < size; ++i) {
        value |= uint64_t{bytes[place + i]} << (8 * i);
    }
    return value;
}

// Of all bytes but its own.
uint64_t checksum_of(std::span<const unsigned char> bytes) noexcept {
    return crc64(bytes.subspan(at_numbers), crc64(bytes.first(at_checksum)));
}

} // namespace

ByteWriter::ByteWriter(Kind kind, const HeaderNumbers &numbers, size_t size) {
    bytes_.reserve(size);
    bytes_.resize(header_size);
    std::ranges::copy(magic, bytes_.begin());
    put_number(major_version, 2, bytes_.data() + at_version);
    put_number(minor_version, 2, bytes_.data() + at_version + 2);
    put_number(static_cast<uint32_t>(kind), 4, bytes_.data() + at_kind);
    for (size_t i = 0; i < numbers.size(); ++i) {
        put_number(static_cast<uint32_t>(numbers[i]), 4, bytes_.data() + at_numbers + 4 * i);
    }
}

void ByteWriter::put(uint64_t value) {
    bytes_.resize(bytes_.size() + 8);
    put_number(value, 8, bytes_.data() + bytes_.size() - 8);
}

void ByteWriter::put(double value) {
    put(std::bit_cast<uint64_t>(value));
}

void ByteWriter::align() {
    bytes_.resize((bytes_.size() + 63) / 64 * 64);
}

std::vector<unsigned char> ByteWriter::finish() {
    put_number(bytes_.size(), 8, bytes_.data() + at_size);
    put_number(checksum_of(bytes_), 8, bytes_.data() + at_checksum);
    return std::move(bytes_);
}

Header read_header(std::span<const unsigned char> bytes) {
    const size_t known = std::min(bytes.size(), magic.size());
    if (!std::equal(magic.begin(), magic.begin() + static_cast<std::ptrdiff_t>(known), bytes.begin())) {
        fail(Status::format, "the bytes do not begin as those of a handle do");
    }
    if (bytes.size() < header_size) {
        fail(Status::truncated, "size = %zu, expected at least the %zu bytes of a header", bytes.size(),
             header_size);
    }
    Header header{};
    header.major = static_cast<uint16_t>(number_at(bytes, at_version, 2));
    header.minor = static_cast<uint16_t>(number_at(bytes, at_version + 2, 2));
    if (header.major > major_version) {
        fail(Status::version, "the bytes have version %d.%d, this library reads versions up to %d",
             header.major, header.minor, major_version);
    }
    const uint64_t size = number_at(bytes, at_size, 8);
    if (size != bytes.size()) {
        fail(size > bytes.size() ? Status::truncated : Status::syntax,
             "size = %zu, expected %llu as the header says", bytes.size(),
             static_cast<unsigned long long>(size));
    }
    if (number_at(bytes, at_checksum, 8) != checksum_of(bytes)) {
        fail(Status::checksum, "the bytes are not those that were written: their checksum differs");
    }
    header.kind = static_cast<Kind>(number_at(bytes, at_kind, 4));
    for (size_t i = 0; i < header.numbers.size(); ++i) {
        header.numbers[i] = static_cast<int32_t>(number_at(bytes, at_numbers + 4 * i, 4));
    }
    return header;
}

ByteReader::ByteReader(std::span<const unsigned char> bytes, Kind kind)
    : bytes_(bytes), header_(read_header(bytes)) {
    if (header_.kind != kind) {
        fail(Status::format, "the bytes hold a handle of kind %u, expected %u",
             static_cast<unsigned>(header_.kind), static_cast<unsigned>(kind));
    }
}

void ByteReader::need(uint64_t count) const {
    if (count > (bytes_.size() - place_) / 8) {
        fail(Status::truncated, "the bytes end before %llu numbers at byte %zu",
             static_cast<unsigned long long>(count), place_);
    }
}

uint64_t ByteReader::take() {
    need(1);
    place_ += 8;
    return number_at(bytes_, place_ - 8, 8);
}

double ByteReader::take_double() {
    return std::bit_cast<double>(take());
}

void ByteReader::align() noexcept {
    place_ = std::min((place_ + 63) / 64 * 64, bytes_.size());
}

} // namespace nrb::io
