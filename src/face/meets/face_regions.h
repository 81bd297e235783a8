// SPDX-License-Identifier: MIT
// Regions that two faces have in common.
#pragma once

#include "face/meets/shared_curve.h"
#include "intersect/levels/level_meet.h"

#include <cstdint>
#include <optional>

namespace nrb::face {

// What both faces have of the regions in which their surfaces are one: parts of these, each with a level of its own, from 1, as of
// surfaces; and what their borders have in common beside them, as edges. The part of the second face in a region is cut out in its
// domain, its border is carried over to that of the first one, and what this has inside of it is cut out there: curves that run
// along each other within the tolerance are one.
class FaceRegions {
public:
    // grounds: the parts of the surfaces, over the same parameters, on which meets are found, and regions in them.
    FaceRegions(const Face &a, const Face &b, const std::array<SplinePtr, 2> &grounds, double tolerance);

    // Of a region of a meet, by its node. None: it is left open what there is.
    [[nodiscard]] std::optional<intersect::Meet> within(const intersect::Meet &surfaces,
                                                        const intersect::MeetNode &region);

private:
    [[nodiscard]] intersect::Meet cut_out(const SharedLoops &loops, bool alike);

    const Face &a_, &b_;
    SharedGrounds grounds_;
    int64_t found_ = 0; // regions
};

} // namespace nrb::face
