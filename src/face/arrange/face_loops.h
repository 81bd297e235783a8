// SPDX-License-Identifier: MIT
// The complete boundary of a face, as loops for an arrangement.
#pragma once

#include "face/arrange/arrangement.h"
#include "face/face.h"

namespace nrb::face {

// The largest gap in space between consecutive curves of the loops of a face: places so far apart have to
// count as one, however small the details of the face are. The tolerance of the face is no substitute, since
// it also says how far edges may be off the surface, which in files is often more.
double largest_gap(const Face &face);

// The loops of a face in their order, and then what they leave open: segments that close gaps, and segments
// along those ends of the domain, poles included, that the face reaches without a curve. Unless the domain is
// closed along both axes, all of these together go around places of the face once and around others never.
std::vector<ArrangedLoop> loops_of(const Face &face, int32_t owner);

// The values of owners at the corner of the domain of an arrangement: how many faces of each owner contain
// it. They are needed where both axes are closed, so that there is no outside from which to count; elsewhere
// they are 0. add() throws Status::not_converged if the corner is on the border of the face.
class AtCorner {
public:
    explicit AtCorner(const Arrangement &arrangement);
    void add(const Face &face, int32_t owner);
    [[nodiscard]] const PassedSums &sums() const noexcept { return sums_; }

private:
    Point2 corner_;
    bool closed_;
    PassedSums sums_;
};

} // namespace nrb::face
