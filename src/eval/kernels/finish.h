// SPDX-License-Identifier: MIT
// The last step of every evaluation, from contracted records to the caller's: the shapes of both, and records
// that are not computed.
#pragma once

#include "base/numbers.h"
#include "base/records.h"
#include "basis/power_spans.h"
#include "eval/kernels/quotient.h"
#include "eval/kernels/slots.h"
#include "spline/spline.h"

namespace nrb::eval {

// A contracted record is [slots][lanes]: components 0, ..., dim - 1, then the weight if the spline is
// rational, then padding. The caller's record is [slots][dim].
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

// Where the function of one control point is 1 and all others are 0, the caller gets the stored control
// point. A parameter that gives NaN has NaN in all components.
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
