// SPDX-License-Identifier: MIT
#include "face/closing_segments.h"

#include "build/polylines.h"
#include "eval/curve_point.h"

namespace nrb::face {
namespace {

Point2 end_of(const PlacedCurve &placed, bool upper) {
    Point2 x;
    eval::end_point(*placed.curve, upper, x.data());
    return {x[0] + placed.shift[0], x[1] + placed.shift[1]};
}

} // namespace

std::vector<SplinePtr> closing_segments(const Face &face, const Loop &loop) {
    std::vector<SplinePtr> segments(loop.size());
    if (!face.has_gaps()) {
        return segments;
    }
    const PlacedLoop all = placed(*face.surface(), face.covering(), loop, face.tolerance());
    for (size_t i = 0; i < loop.size(); ++i) {
        const Point2 a = end_of(all.curves[i], true);
        Point2 b = end_of(all.curves[(i + 1) % loop.size()], false);
        if (i + 1 == loop.size()) {
            b = {b[0] + all.turn[0], b[1] + all.turn[1]};
        }
        if (gap_between(*face.surface(), face.covering(), a, b) > face.tolerance()) {
            segments[i] = build::polyline(2, {a[0], a[1], b[0], b[1]}, {0, 1});
        }
    }
    return segments;
}

} // namespace nrb::face
