// SPDX-License-Identifier: MIT
// Regions in which two faces coincide.
#pragma once

#include "face/meets/shared_curve.h"
#include "intersect/levels/level_meet.h"

#include <cstdint>
#include <optional>

namespace nrb::face {

// What two faces have in common in the regions in which their surfaces coincide: parts of these regions, each
// with a level of its own, counted from 1 as for surfaces; and curves along which their borders coincide
// beside the parts, as edges. Two steps: the part of the second face in a region is cut out in the domain of
// the second surface. Its border is carried over to the domain of the first surface, and the part of the
// first face inside of it is cut out there. Curves that run along each other within the tolerance are one.
class FaceRegions {
public:
    // grounds: the parts of the surfaces, over the same parameters, of which the meet and its regions were
    // computed.
    FaceRegions(const Face &a, const Face &b, const std::array<SplinePtr, 2> &grounds, double tolerance);

    // For a region of a meet, given by its node. None if it is left open what the faces have in common there.
    [[nodiscard]] std::optional<intersect::Meet> within(const intersect::Meet &surfaces,
                                                        const intersect::MeetNode &region);

private:
    [[nodiscard]] intersect::Meet cut_out(const SharedLoops &loops, bool alike);

    const Face &a_, &b_;
    SharedGrounds grounds_;
    int64_t found_ = 0; // number of regions
};

} // namespace nrb::face
