// SPDX-License-Identifier: MIT
#include "face/near/space_edges.h"

#include "base/numbers.h"
#include "bounds/box.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"

#include <algorithm>

namespace nrb::face {

double SpaceEdge::distance(const double *box_lower, const double *box_upper) const noexcept {
    const double computed = norm_of(static_cast<int>(lower.size()), [&](int c) {
        const auto at = static_cast<size_t>(c);
        return std::max({lower[at] - box_upper[c], box_lower[c] - upper[at], 0.0});
    });
    return computed * (1 - 16 * eps);
}

namespace {

// Whether the surface jumps along a curve of the domain, because one of its coordinates is constant and equal
// to a knot at which the surface jumps. The face ends with one of the two limits, and the curve in space may
// be the other one.
bool follows_jump(const Spline &surface, const Spline &curve) {
    for (int k = 0; k < 2; ++k) {
        const KnotVector &axis = surface.axis(k);
        const Interval domain = axis.domain();
        const double t = curve.coordinate(0, k);
        bool along = t > domain.lower && t < domain.upper && multiplicity(axis.knots(), t) > axis.degree();
        for (int64_t i = 1; i < curve.point_count() && along; ++i) {
            along = curve.coordinate(i, k) == t;
        }
        if (along) {
            return true;
        }
    }
    return false;
}

} // namespace

SpaceEdges space_edges(const Face &face) {
    SpaceEdges edges;
    for (BoundaryCurve &curve : boundary_curves(face)) {
        if (curve.space == nullptr) {
            edges.exact = false;
            curve.space = edge_over(face.surface(), face.covering(), curve.plane, face.tolerance()).curve;
        }
        edges.exact = edges.exact && !follows_jump(*face.surface(), *curve.plane);
        const bounds::Box box = bounds::bounding_box(*curve.space, whole_domain(*curve.space), infinity);
        edges.all.push_back({std::move(curve), box.lower, box.upper});
    }
    return edges;
}

Point2 place_of(const Face &face, const SpaceEdges &edges) {
    if (edges.all.empty()) {
        return {face.covering().domain(0).lower, face.covering().domain(1).lower};
    }
    const BoundaryCurve &first = edges.all.front().curve;
    return place_on(face, first, first.plane->axis(0).domain().lower, false);
}

Point2 place_on(const Face &face, const BoundaryCurve &curve, double t, bool left) {
    Point2 place{};
    eval::curve_point(*curve.plane, t, left, place.data());
    return face.covering().in_domain(place);
}

} // namespace nrb::face
