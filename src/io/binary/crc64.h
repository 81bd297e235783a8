// SPDX-License-Identifier: MIT
// A checksum that finds every burst of errors of up to 64 bits.
#pragma once

#include <cstdint>
#include <span>

namespace nrb::io {

// The polynomial of ECMA-182, bits reflected, as xz has it: that of "123456789" is 0x995DC9BBDF1939FA. `before` is the
// checksum of the bytes before.
uint64_t crc64(std::span<const unsigned char> bytes, uint64_t before = 0) noexcept;

} // namespace nrb::io
