// SPDX-License-Identifier: MIT
#include "io/binary/crc64.h"

#include <array>

namespace nrb::io {

namespace {

// Row r holds the effect of a byte after r more bytes.
using Tables = std::array<std::array<uint64_t, 256>, 8>;

constexpr Tables make_tables() noexcept {
    constexpr uint64_t polynomial = 0xC96C5795D7870F42u;
    Tables tables{};
    for (uint64_t byte = 0; byte < 256; ++byte) {
        uint64_t sum = byte;
        for (int bit = 0; bit < 8; ++bit) {
            sum = sum >> 1 ^ ((sum & 1) != 0 ? polynomial : 0);
        }
        tables[0][byte] = sum;
    }
    for (size_t r = 1; r < tables.size(); ++r) {
        for (size_t byte = 0; byte < 256; ++byte) {
            const uint64_t sum = tables[r - 1][byte];
            tables[r][byte] = sum >> 8 ^ tables[0][sum & 0xff];
        }
    }
    return tables;
}

} // namespace

// Processes eight bytes at a time (slicing by 8).
uint64_t crc64(std::span<const unsigned char> bytes, uint64_t before) noexcept {
    static constexpr Tables tables = make_tables();
    uint64_t sum = ~before;
    size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
        for (size_t k = 0; k < 8; ++k) {
            sum ^= uint64_t{bytes[i + k]} << (8 * k);
        }
        uint64_t next = 0;
        for (size_t k = 0; k < 8; ++k) {
            next ^= tables[7 - k][sum >> (8 * k) & 0xff];
        }
        sum = next;
    }
    for (; i < bytes.size(); ++i) {
        sum = sum >> 8 ^ tables[0][(sum ^ bytes[i]) & 0xff];
    }
    return ~sum;
}

} // namespace nrb::io
