// SPDX-License-Identifier: MIT
// All that bounds a face, as curves of an arrangement.
#pragma once

#include "face/arrange/arrangement.h"
#include "face/face.h"

namespace nrb::face {

// Of the curves of all loops, in space: what has to be one place, however little the details of a face are. Its tolerance says how far
// edges may be off it, which in files is often more.
double largest_gap(const Face &face);

// Its loops in their order, then what they leave open: segments that close gaps, and those along ends of the domain, poles among
// them, which the face reaches without a curve. Together they go around places of the face once and around others never, if the domain is not
// closed along both axes.
std::vector<ArrangedLoop> loops_of(const Face &face, int32_t owner);

// How often faces go around the corner of the arrangement, by owners, where that cannot be counted from outside: where both axes
// are closed. Throws Status::not_converged if a face has the corner on its border.
class AtCorner {
public:
    explicit AtCorner(const Arrangement &arrangement);
    void add(const Face &face, int32_t owner);
    [[nodiscard]] const PassedSums &sums() const noexcept { return sums_; }

private:
    const Arrangement &arrangement_;
    Point2 corner_;
    bool closed_;
    PassedSums sums_;
};

} // namespace nrb::face
