// SPDX-License-Identifier: MIT
// The binary form of statistics.
#pragma once

#include "fit/statistics/statistics.h"
#include "io/binary/envelope.h"

namespace nrb::io {

// The numbers of the header are axes, dim, and the exponents of the scales of values and of weights. The
// body, each part at a multiple of 64 bytes:
//
//     number of cells with data, number of sums of a cell; for each axis its degree and the number of its
//         breaks
//     the breaks of all axes, one axis after the other
//     the indices of the cells with data, ascending; the number of data in each of them
//     the sums of all cells, 24 bytes each, in two's complement
//
// The same statistics have the same bytes on every machine.
size_t size_in_bytes(const fit::Statistics &statistics) noexcept;
// Precondition: `out` has size_in_bytes() bytes.
void write_bytes(const fit::Statistics &statistics, std::span<unsigned char> out) noexcept;

// Throws what ByteReader throws, and Status::syntax for numbers that no statistics have.
fit::Statistics statistics_from(std::span<const unsigned char> bytes);

} // namespace nrb::io
