// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/kernels/triple_stream.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/frames/frame_outputs.h"
#include "eval/kernels/horner-inl.h"
#include "eval/kernels/triple_stream.h"

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// Turns three rows into packed triples.
void interleave(const double *HWY_RESTRICT rows, int64_t count, double *HWY_RESTRICT triples) {
    const Vec8 d;
    const double *y = rows + block_size;
    const double *z = y + block_size;
    int64_t i = 0;
    for (; i + vec8_lanes <= count; i += vec8_lanes) {
        hn::StoreInterleaved3(hn::LoadU(d, rows + i), hn::LoadU(d, y + i), hn::LoadU(d, z + i), d,
                              triples + 3 * i);
    }
    for (; i < count; ++i) {
        triples[3 * i] = rows[i];
        triples[3 * i + 1] = y[i];
        triples[3 * i + 2] = z[i];
    }
}

// Streaming copy. Preconditions: both arrays begin at cache lines, and `count` is a multiple of 8.
void stream(const double *HWY_RESTRICT from, int64_t count, double *HWY_RESTRICT to) {
    const Vec8 d;
    for (int64_t i = 0; i < count; i += vec8_lanes) {
        hn::Stream(hn::Load(d, from + i), d, to + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(interleave);
NURBS_FORMS(stream);

void TripleStream::write(const double *rows, int64_t first, int64_t count) noexcept {
    if (!streamed_ || out_.data == nullptr) {
        return write_rows(rows, first, count, out_);
    }
    if (target_ == nullptr || out_.record(first) != target_ + (end_ - begin_)) {
        start(out_.record(first));
    }
    NURBS_BEST(interleave)(rows, count, staged_ + end_);
    end_ += 3 * count;
    const int64_t whole = end_ / line * line;
    if (whole == 0) {
        return;
    }
    const int64_t part = begin_ == 0 ? 0 : line; // a line of which the beginning is not ours
    std::copy(staged_ + begin_, staged_ + part, target_);
    NURBS_BEST(stream)(staged_ + part, whole - part, target_ + (part - begin_));
    std::copy(staged_ + whole, staged_ + end_, staged_);
    target_ += whole - begin_;
    begin_ = 0;
    end_ -= whole;
}

void TripleStream::start(double *target) noexcept {
    finish();
    begin_ = static_cast<int64_t>(reinterpret_cast<uintptr_t>(target) / sizeof(double) % line);
    end_ = begin_;
    target_ = target;
}

void TripleStream::finish() noexcept {
    if (target_ != nullptr) {
        std::copy(staged_ + begin_, staged_ + end_, target_);
        hwy::FlushStream();
    }
}

} // namespace nrb::eval
#endif
