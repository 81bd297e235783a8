// SPDX-License-Identifier: MIT
// Nearest points of faces.
#pragma once

#include "base/numbers.h"
#include "closest/locator.h"
#include "face/near/space_edges.h"

#include <optional>

namespace nrb::face {

// Finds nearest points of a face. If the nearest point of its surface lies inside, it is that one. Else it is
// the nearest of the points of the boundary, and of the local minima of the distance that lie inside. Only
// one call at a time; the face must outlive this.
class FaceLocator {
public:
    explicit FaceLocator(const Face &face) noexcept : face_(face) {}

    // point: [dim], finite. tolerance: how much nearer another point may be. The status has closest_ bits;
    // closest_boundary is for the boundary of the face. If the whole surface is proven to be farther than
    // `far`, its foot is the answer, inside or not. At the limit of work the answer is some place of the
    // face.
    [[nodiscard]] closest::BoundedFoot nearest(const double *point, double tolerance, double far = infinity);

private:
    struct Found {
        closest::Foot foot;
        bool certified;
    };
    [[nodiscard]] Found on_edges(const double *point, double tolerance);
    [[nodiscard]] closest::Foot nearest_inside(const double *point, double tolerance,
                                               const closest::Foot &least);
    [[nodiscard]] closest::Foot any_foot(const double *point) const;
    [[nodiscard]] int side(const closest::Foot &foot) const noexcept;

    const Face &face_;
    std::optional<SpaceEdges> edges_; // made when they are needed
};

} // namespace nrb::face
