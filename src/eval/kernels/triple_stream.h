// SPDX-License-Identifier: MIT
// Packed triples of large results, written past the caches.
#pragma once

#include "base/records.h"
#include "eval/blocks.h"

namespace nrb::eval {

// An ordinary store reads the line that it writes to. For results that no cache can hold, this is half of the
// traffic, and it displaces data that could be held. Here lines of 64 bytes are put together and written as a
// whole without reading. Blocks that follow each other in memory share the line where they meet; any other
// order is allowed but slower. The caller's layout decides: triples that are not packed are written by
// write_rows().
class TripleStream {
public:
    // `large`: whether all results of the call together are_large(). `out` must outlive the stream.
    TripleStream(const Records &out, bool large) noexcept
        : out_(out), streamed_(large && out.width == 3 && out.stride == 3 && out.component_stride == 1 &&
                               reinterpret_cast<uintptr_t>(out.data) % sizeof(double) == 0) {}
    TripleStream(const TripleStream &) = delete;
    TripleStream &operator=(const TripleStream &) = delete;
    ~TripleStream() { finish(); }

    // Records first, ..., first + count - 1 from three rows of a block; nothing if `out` is not wanted.
    void write(const double *rows, int64_t first, int64_t count) noexcept;

    // More than the caches that one core can expect to have.
    [[nodiscard]] static constexpr bool are_large(int64_t doubles) noexcept {
        return doubles > (int64_t{32} << 20) / static_cast<int64_t>(sizeof(double));
    }

private:
    static constexpr int64_t line = 8;
    void start(double *target) noexcept;
    void finish() noexcept;

    const Records &out_;
    bool streamed_;
    double *target_ = nullptr; // where staged_[begin_] will go
    int64_t begin_ = 0;        // of what is staged; staged_[0] belongs at the start of a line
    int64_t end_ = 0;
    alignas(64) double staged_[line + 3 * block_size];
};

} // namespace nrb::eval
