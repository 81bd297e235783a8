// SPDX-License-Identifier: MIT
// The splines in the body of a list, or of any other handle that has several: each stands there once, however often it
// occurs, as a whole with a header of its own, which can be cut out and read alone.
//
//     where the splines begin, from the start of the header of what holds them (64 bits each)
//     the splines, each at a multiple of 64 bytes
#pragma once

#include "io/binary/envelope.h"
#include "spline/spline.h"

#include <unordered_map>

namespace nrb::io {

class SplineTable {
public:
    // The index of a spline. Those whose bytes are the same have the same index; others are counted as they come.
    int64_t add(const SplinePtr &spline);

    [[nodiscard]] int64_t count() const noexcept { return std::ssize(splines_); }
    // From the beginning of a part to its end.
    [[nodiscard]] size_t size_in_bytes() const noexcept;
    // Where a part begins.
    void write(ByteWriter &writer) const noexcept;

private:
    int64_t add_contents(const SplinePtr &spline);

    std::vector<SplinePtr> splines_;
    std::unordered_map<SplinePtr, int64_t> known_;
    std::unordered_multimap<uint64_t, int64_t> by_checksum_;
};

// The splines of a table of `count`, at the beginning of a part. Throws what spline_from() does, and Status::syntax.
std::vector<SplinePtr> splines_from(ByteReader &reader, int64_t count);

} // namespace nrb::io
