// SPDX-License-Identifier: MIT
#include "io/binary/envelope.h"

#include "base/error.h"
#include "io/binary/crc64.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

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

// memcpy(), also for no bytes, whose pointers may be null.
void copy_bytes(const void *from, size_t size, void *to) noexcept {
    if (size > 0) {
        std::memcpy(to, from, size);
    }
}

// The checksum of all bytes but those of the checksum itself.
uint64_t checksum_of(std::span<const unsigned char> bytes) noexcept {
    return crc64(bytes.subspan(at_numbers), crc64(bytes.first(at_checksum)));
}

// The name of a kind with its article; of a kind from a later version of the library, its number.
std::string name_of(Kind kind) {
    switch (kind) {
    case Kind::spline:
        return "a spline";
    case Kind::list:
        return "a list";
    case Kind::statistics:
        return "statistics";
    case Kind::face:
        return "a face";
    case Kind::model:
        return "a model";
    }
    return "a handle of kind " + std::to_string(static_cast<uint32_t>(kind));
}

} // namespace

ByteWriter::ByteWriter(Kind kind, const HeaderNumbers &numbers, std::span<unsigned char> out) noexcept
    : bytes_(out) {
    std::fill_n(bytes_.begin(), header_size, static_cast<unsigned char>(0));
    std::copy(magic.begin(), magic.end(), bytes_.begin());
    put_number(major_version, 2, bytes_.data() + at_version);
    put_number(minor_version, 2, bytes_.data() + at_version + 2);
    put_number(static_cast<uint32_t>(kind), 4, bytes_.data() + at_kind);
    for (size_t i = 0; i < numbers.size(); ++i) {
        put_number(static_cast<uint32_t>(numbers[i]), 4, bytes_.data() + at_numbers + 4 * i);
    }
}

void ByteWriter::put(uint64_t value) noexcept {
    put_number(value, 8, room(8).data());
}

void ByteWriter::put(double value) noexcept {
    put(std::bit_cast<uint64_t>(value));
}

void ByteWriter::put(std::span<const double> values) noexcept {
    if constexpr (std::endian::native == std::endian::little) {
        copy_bytes(values.data(), values.size_bytes(), room(values.size_bytes()).data());
    } else {
        for (const double value : values) {
            put(value);
        }
    }
}

void ByteWriter::put(std::string_view text) noexcept {
    copy_bytes(text.data(), text.size(), room(text.size()).data());
}

void ByteWriter::align() noexcept {
    const std::span<unsigned char> rest = room(std::min(aligned(place_), bytes_.size()) - place_);
    std::fill(rest.begin(), rest.end(), static_cast<unsigned char>(0));
}

std::span<unsigned char> ByteWriter::room(size_t size) noexcept {
    place_ += size;
    return bytes_.subspan(place_ - size, size);
}

void ByteWriter::finish() noexcept {
    put_number(bytes_.size(), 8, bytes_.data() + at_size);
    put_number(checksum_of(bytes_), 8, bytes_.data() + at_checksum);
}

Header read_kind(std::span<const unsigned char> bytes) {
    const size_t known = std::min(bytes.size(), magic.size());
    if (!std::equal(magic.begin(), magic.begin() + static_cast<std::ptrdiff_t>(known), bytes.begin())) {
        fail(Status::format, "the bytes do not begin as those of a handle do");
    }
    if (bytes.size() < header_size) {
        fail(Status::truncated, "size = %zu, expected at least the %zu bytes of a header", bytes.size(),
             header_size);
    }
    Header header{};
    header.kind = static_cast<Kind>(number_at(bytes, at_kind, 4));
    header.major = static_cast<uint16_t>(number_at(bytes, at_version, 2));
    header.minor = static_cast<uint16_t>(number_at(bytes, at_version + 2, 2));
    return header;
}

Header read_header(std::span<const unsigned char> bytes) {
    Header header = read_kind(bytes);
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
    for (size_t i = 0; i < header.numbers.size(); ++i) {
        header.numbers[i] = static_cast<int32_t>(number_at(bytes, at_numbers + 4 * i, 4));
    }
    return header;
}

ByteReader::ByteReader(std::span<const unsigned char> bytes, Kind kind)
    : bytes_(bytes), header_(read_header(bytes)) {
    if (header_.kind != kind) {
        fail(Status::format, "the bytes hold %s, expected %s", name_of(header_.kind).c_str(),
             name_of(kind).c_str());
    }
}

void ByteReader::need(uint64_t count) const {
    if (count > (bytes_.size() - place_) / 8) {
        fail(Status::truncated, "the bytes end before %llu numbers at byte %zu",
             static_cast<unsigned long long>(count), place_);
    }
}

ByteReader ByteReader::part(int64_t count, size_t numbers) {
    need(static_cast<uint64_t>(count)); // so that the product does not overflow
    need(static_cast<uint64_t>(count) * numbers);
    ByteReader here = *this;
    place_ += 8 * static_cast<size_t>(count) * numbers;
    align();
    return here;
}

uint64_t ByteReader::take() {
    need(1);
    place_ += 8;
    return number_at(bytes_, place_ - 8, 8);
}

double ByteReader::take_double() {
    return std::bit_cast<double>(take());
}

std::vector<double> ByteReader::take_doubles(int64_t count, size_t spare) {
    need(static_cast<uint64_t>(count));
    const auto size = static_cast<size_t>(count);
    std::vector<double> values;
    values.reserve(size + spare); // need() has shown that the bytes hold so many
    values.resize(size);
    if constexpr (std::endian::native == std::endian::little) {
        copy_bytes(bytes_.data() + place_, 8 * size, values.data());
        place_ += 8 * size;
    } else {
        std::generate(values.begin(), values.end(), [this] { return take_double(); });
    }
    return values;
}

std::vector<int64_t> ByteReader::take_integers(int64_t count) {
    need(static_cast<uint64_t>(count));
    std::vector<int64_t> values(static_cast<size_t>(count));
    std::generate(values.begin(), values.end(), [this] { return take_integer(); });
    return values;
}

std::string_view ByteReader::take_text(int64_t size) {
    if (size < 0 || static_cast<uint64_t>(size) > bytes_.size() - place_) {
        fail(Status::truncated, "the bytes end before a text of %lld bytes at byte %zu",
             static_cast<long long>(size), place_);
    }
    place_ += static_cast<size_t>(size);
    return {reinterpret_cast<const char *>(bytes_.data()) + place_ - size, static_cast<size_t>(size)};
}

std::span<const unsigned char> ByteReader::take_record(int64_t place) {
    check_place(place, "a record");
    if (bytes_.size() - place_ < header_size) {
        fail(Status::truncated, "the bytes end before a record at byte %zu", place_);
    }
    const uint64_t size = number_at(bytes_, place_ + at_size, 8);
    if (size < header_size || size > bytes_.size() - place_) {
        fail(Status::truncated, "the record at byte %zu has %llu bytes, which are not there", place_,
             static_cast<unsigned long long>(size));
    }
    place_ += static_cast<size_t>(size);
    return bytes_.subspan(place_ - static_cast<size_t>(size), static_cast<size_t>(size));
}

void ByteReader::check_place(int64_t place, const char *part) const {
    if (place < 0 || static_cast<uint64_t>(place) != place_) {
        fail(Status::syntax, "%s at byte %lld, expected at byte %zu", part, static_cast<long long>(place),
             place_);
    }
}

void ByteReader::align() noexcept {
    place_ = std::min(aligned(place_), bytes_.size());
}

void ByteReader::end() const {
    const bool later = header_.major == major_version && header_.minor > minor_version;
    if (place_ < bytes_.size() && !later) {
        fail(Status::syntax, "%zu bytes behind the last part, which ends at byte %zu", bytes_.size() - place_,
             place_);
    }
}

} // namespace nrb::io
