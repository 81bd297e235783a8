// SPDX-License-Identifier: MIT
// Streaming stores: packed triples of large results, written to memory past the caches.
#pragma once

#include "base/records.h"
#include "eval/blocks.h"

namespace nrb::eval {

// An ordinary store first reads the cache line that it writes to. For results larger than any cache, this is
// half of the memory traffic, and it evicts data that could have stayed. A TripleStream collects whole lines
// of 64 bytes and writes them without reading them. Blocks that follow each other in memory share the line in
// which they meet; any other order is allowed, but slower. Results whose layout in the caller's memory is not
// packed are written by write_rows().
class TripleStream {
public:
    // `large`: whether all results of the call together are_large(). `out` must outlive the stream.
    TripleStream(const Records &out, bool large) noexcept
        : out_(out), streamed_(large && out.width == 3 && out.stride == 3 && out.component_stride == 1 &&
                               reinterpret_cast<uintptr_t>(out.data) % sizeof(double) == 0) {}
    TripleStream(const TripleStream &) = delete;
    TripleStream &operator=(const TripleStream &) = delete;
    ~TripleStream() { finish(); }

    // Writes records first, ..., first + count - 1 from three rows of a block. Does nothing if `out` is not
    // wanted.
    void write(const double *rows, int64_t first, int64_t count) noexcept;

    // Whether results of this size exceed the caches that one core can expect to have.
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
    int64_t begin_ = 0;        // begin of the staged doubles; staged_[0] is the start of a line
    int64_t end_ = 0;
    alignas(64) double staged_[line + 3 * block_size];
};

} // namespace nrb::eval
