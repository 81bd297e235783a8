// SPDX-License-Identifier: MIT
// Nearest points of faces.
#pragma once

#include "base/numbers.h"
#include "closest/locator.h"
#include "face/near/space_edges.h"

#include <optional>

namespace nrb::face {

// Of the surface, if its nearest point lies inside; else of the boundary, and of local minima inside that are nearer. Calls with
// one point after the other; the face has to stay.
class FaceLocator {
public:
    explicit FaceLocator(const Face &face) noexcept : face_(face) {}

    // point: [dim], finite. tolerance: how much nearer another point may be. Status: closest_ bits; closest_boundary is that of the
    // face. Where the whole surface is farther than `far` for certain its foot is the answer, inside or not. At the limit of work
    // it is some place of the face.
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
    std::optional<SpaceEdges> edges_; // when they are first asked for
};

} // namespace nrb::face
