// SPDX-License-Identifier: MIT
#include "reduce/snap.h"

#include "reduce/knot_clusters.h"
#include "reduce/layer_deviation.h"

namespace nrb::reduce {

void check_relative_tolerance(double tolerance) {
    if (!(tolerance >= 0 && tolerance < 1)) {
        fail(Status::tolerance, "tolerance = %s, a part of the domain's length, expected >= 0 and < 1",
             Number(tolerance).text);
    }
}

SplinePtr over_axis(const Spline &spline, int k, const refine::AxisTable &moved) {
    Net net = apply_along(spline, k, moved.table);
    return std::make_shared<const Spline>(refine::with_axis(spline, k, moved.axis), spline.dim(),
                                          spline.form(), std::move(net.points), std::move(net.weights));
}

Snapped snap_knots(const SplinePtr &spline, int axis, double tolerance) {
    check_relative_tolerance(tolerance);
    const KnotVectorPtr &old = spline->knot_vectors()[static_cast<size_t>(axis)];
    const Interval domain = old->domain();
    const KnotClusters clusters(distinct_knots(old->knots()), domain,
                                tolerance * (domain.upper - domain.lower));
    const refine::AxisTable moved = moved_axis(old, clusters, axis, "");
    if (moved.axis == old) {
        return {spline, 0};
    }
    SplinePtr snapped = over_axis(*spline, axis, moved);
    check_spline(*snapped, Values::computed); // merged knots may leave places without weights
    const double deviation = deviation_bound(spline, snapped);
    return {std::move(snapped), deviation};
}

} // namespace nrb::reduce
