// SPDX-License-Identifier: MIT
// What the last step of every evaluation needs: the shape of contracted records and of the caller's records.
#pragma once

#include "base/numbers.h"
#include "base/records.h"
#include "basis/power_spans.h"
#include "eval/kernels/quotient.h"
#include "eval/kernels/slots.h"
#include "spline/spline.h"

namespace nrb::eval {

// A contracted record is [slots][lanes]: components 0, ..., dim - 1, then the weight if rational, then
// padding. The caller's record is [slots][dim].
struct RecordShape {
    RecordShape(const Spline &spline, int highest_order) noexcept
        : axes(spline.axes()), order(highest_order), dim(spline.dim()), width(spline.width()),
          lanes(PowerSpan::lanes(spline.width())), slots(slot_count(spline.axes(), highest_order)),
          rational(spline.rational()) {}

    [[nodiscard]] int64_t size() const noexcept { return slots * lanes; }
    [[nodiscard]] int64_t values() const noexcept { return slots * dim; }

    int axes;
    int order;
    int dim;
    int width;
    int lanes;
    int64_t slots;
    bool rational;
};

// The caller's arrays hold stored control points where one control point is alone, and NaN where nothing was
// evaluated.
inline void write_control_point(const Spline &spline, int64_t point, const Records &out, int64_t i) noexcept {
    for (int c = 0; c < spline.dim(); ++c) {
        out(i, c) = spline.coordinate(point, c);
    }
}

inline void write_nan(int64_t values, const Records &out, int64_t i) noexcept {
    for (int64_t c = 0; c < values; ++c) {
        out(i, c) = nan_value;
    }
}

} // namespace nrb::eval
