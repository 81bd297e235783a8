// SPDX-License-Identifier: MIT
// Nearest points of faces.
#pragma once

#include "closest/locator.h"
#include "face/boundary.h"

#include <vector>

namespace nrb::face {

// Of the surface, if its nearest point lies inside; else of the boundary, and of local minima inside that are nearer. Calls with
// one point after the other; the face has to stay.
class FaceLocator {
public:
    explicit FaceLocator(const Face &face) noexcept : face_(face) {}

    // point: [dim], finite. tolerance: how much nearer another point may be. Status: closest_ bits; closest_boundary is that of the
    // face.
    [[nodiscard]] closest::Foot nearest(const double *point, double tolerance);

private:
    struct Edge {
        BoundaryCurve curve;
        std::vector<double> lower, upper; // of its box
    };
    struct Found {
        closest::Foot foot;
        bool certified;
    };
    void find_edges();
    [[nodiscard]] double distance_of(const Edge &edge, const double *point) const noexcept;
    [[nodiscard]] Found on_edges(const double *point, double tolerance);
    [[nodiscard]] closest::Foot nearest_inside(const double *point, double tolerance,
                                               const closest::Foot &least);
    [[nodiscard]] int side(const closest::Foot &foot) const noexcept;

    const Face &face_;
    bool known_ = false, composed_ = true; // whether edges are known, and all of them exactly
    std::vector<Edge> edges_;
};

} // namespace nrb::face
