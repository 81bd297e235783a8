// SPDX-License-Identifier: MIT
#include "build/coons/volume_edge.h"

namespace nrb::build {

void VolumeEdge::check(double gap, double tolerance) const {
    if (!(gap <= tolerance)) {
        fail(Status::gap,
             "edge along axis %d at the %s of axis %d and the %s of axis %d: faces[%zu] and faces[%zu] are "
             "up to %s "
             "apart, expected at most %s",
             axis, first_upper ? "end" : "start", first, second_upper ? "end" : "start", second, face(),
             other_face(), Number(gap).text, Number(tolerance).text);
    }
}

std::array<Interval, 3> volume_domains(const std::vector<SplinePtr> &faces) {
    return {faces[2]->axis(0).domain(), faces[0]->axis(0).domain(), faces[0]->axis(1).domain()};
}

} // namespace nrb::build
