// SPDX-License-Identifier: MIT
// Regions that two faces share, as branches and nodes of a meet.
#pragma once

#include "face/meets/shared_curve.h"
#include "intersect/levels/level_meet.h"

#include <cstdint>

namespace nrb::face {

// Adds regions, and edges beside them, to a meet.
class RegionBranches {
public:
    RegionBranches(const SharedGrounds &grounds, intersect::Meet &meet) : grounds_(grounds), meet_(meet) {}

    // Adds the border of a region as branches, with the region to their left in the domain of the first
    // surface, and the node of the region. Throws Status::not_converged if the region is so thin that no
    // place inside is found, or if the other surface is not there at that place.
    void add_region(const SharedLoops &loops, int64_t level);
    // Adds a curve along which two borders coincide.
    void add_edge(const SharedCurve &curve);

private:
    void add_loop(const SharedLoop &loop, int64_t level);
    void add_branch(const SharedCurve &curve, intersect::BranchKind kind, int64_t level,
                    const std::array<int64_t, 2> &nodes, int64_t loop);
    int64_t add_node(const SharedCurve &curve, bool upper, intersect::NodeKind kind, int64_t level);
    void join(const SharedCurve &before, const SharedCurve &after, int64_t level, int64_t &end,
              int64_t &begin);
    [[nodiscard]] bool goes_on_in_itself(const SharedCurve &curve) const;

    const SharedGrounds &grounds_;
    intersect::Meet &meet_;
    int64_t loops_ = 0;
};

} // namespace nrb::face
