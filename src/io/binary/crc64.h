// SPDX-License-Identifier: MIT
// CRC-64: a checksum that detects every burst of errors of up to 64 bits.
#pragma once

#include <cstdint>
#include <span>

namespace nrb::io {

// The polynomial is that of ECMA-182, with reflected bits, as in xz: the checksum of "123456789" is
// 0x995DC9BBDF1939FA. `before`: the checksum of the bytes that precede these.
uint64_t crc64(std::span<const unsigned char> bytes, uint64_t before = 0) noexcept;

} // namespace nrb::io
