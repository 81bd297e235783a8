// SPDX-License-Identifier: MIT
#include "face/made/projected_curve.h"

#include "face/trimmed_meet.h"
#include "intersect/pairs/periods.h"

namespace nrb::face {

intersect::Meet projected_along(const SplinePtr &curve, const Face &face, const Vector3 &direction,
                                double tolerance) {
    intersect::Meet meet =
        trimmed(face, intersect::projected_along(curve, *face.surface(), direction, tolerance));
    for (intersect::MeetNode &node : meet.nodes) { // those on loops are where branches are, in any period
        const double shift = intersect::shift_of(*curve, node.at_second[0]);
        for (double *t : {&node.at_second[0], &node.range_second[0].lower, &node.range_second[0].upper}) {
            *t += shift;
        }
    }
    return meet;
}

} // namespace nrb::face
