// SPDX-License-Identifier: MIT
// A control net seen along one axis, as an array [outer][count][inner] with the layers of the axis in the
// middle. A layer is all control points with one index along the axis: a point of a curve, a row of a
// surface, a sheet of a volume. Every operation along an axis works on this view, so that one loop serves
// curves, surfaces and volumes.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

struct AxisView {
    int64_t outer; // product of the counts of the axes before
    int64_t count; // layers along the axis
    int64_t inner; // product of the counts of the axes after, times the width of a record
};

inline AxisView axis_view(const Spline &spline, int axis, int64_t width) noexcept {
    AxisView view{1, spline.count(axis), width};
    for (int k = 0; k < axis; ++k) {
        view.outer *= spline.count(k);
    }
    for (int k = axis + 1; k < spline.axes(); ++k) {
        view.inner *= spline.count(k);
    }
    return view;
}

} // namespace nrb::inline spline
