// SPDX-License-Identifier: MIT
#include "face/near/space_edges.h"

#include "base/numbers.h"
#include "bounds/box.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"

#include <algorithm>

namespace nrb::face {

double SpaceEdge::distance(const double *box_lower, const double *box_upper) const noexcept {
    return norm_of(static_cast<int>(lower.size()), [&](int c) {
        const auto at = static_cast<size_t>(c);
        return std::max({lower[at] - box_upper[c], box_lower[c] - upper[at], 0.0});
    });
}

SpaceEdges space_edges(const Face &face) {
    SpaceEdges edges;
    for (BoundaryCurve &curve : boundary_curves(face)) {
        if (curve.space == nullptr) {
            edges.exact = false;
            curve.space = edge_over(face.surface(), face.covering(), curve.plane, face.tolerance()).curve;
        }
        const bounds::Box box = bounds::bounding_box(*curve.space, whole_domain(*curve.space), infinity);
        edges.all.push_back({std::move(curve), box.lower, box.upper});
    }
    return edges;
}

Point2 place_on(const Face &face, const BoundaryCurve &curve, double t, bool left) {
    Point2 place{};
    eval::curve_point(*curve.plane, t, left, place.data());
    return face.covering().in_domain(place);
}

} // namespace nrb::face
