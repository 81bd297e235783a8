// SPDX-License-Identifier: MIT
// The splines in the body of a list, or of any other handle that has several. Each distinct spline is stored
// once, however often it occurs, as a complete handle with its own header, which can be cut out and read
// alone.
//
//     where each spline begins, counted from the start of the whole handle (64 bits each)
//     the splines, each at a multiple of 64 bytes
#pragma once

#include "io/binary/envelope.h"
#include "spline/spline.h"

#include <unordered_map>

namespace nrb::io {

class SplineTable {
public:
    // The index of a spline. Splines with the same bytes share an index; new ones are numbered in the order
    // in which they are added.
    int64_t add(const SplinePtr &spline);

    [[nodiscard]] int64_t count() const noexcept { return std::ssize(splines_); }
    // The size from the start of the part to its end, padding included.
    [[nodiscard]] size_t size_in_bytes() const noexcept;
    // Precondition: the writer is at the start of a part.
    void write(ByteWriter &writer) const noexcept;

private:
    int64_t add_contents(const SplinePtr &spline);

    std::vector<SplinePtr> splines_;
    std::unordered_map<SplinePtr, int64_t> known_;
    std::unordered_multimap<uint64_t, int64_t> by_checksum_;
};

// Reads a table of `count` splines, at the start of a part. Throws what spline_from() throws, and
// Status::syntax.
std::vector<SplinePtr> splines_from(ByteReader &reader, int64_t count);

} // namespace nrb::io
