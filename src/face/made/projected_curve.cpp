// SPDX-License-Identifier: MIT
#include "face/made/projected_curve.h"

#include "face/trimmed_meet.h"

namespace nrb::face {

intersect::Meet projected_along(const SplinePtr &curve, const Face &face, const Vector3 &direction,
                                double tolerance) {
    return trimmed(face, intersect::projected_along(curve, *face.surface(), direction, tolerance));
}

intersect::Meet projected_normally(const SplinePtr &curve, const Face &face, double tolerance) {
    return trimmed(face, intersect::projected_normally(curve, *face.surface(), tolerance));
}

} // namespace nrb::face
