// SPDX-License-Identifier: MIT
// The part of a surface that polygons in its domain bound, as triangles.
#pragma once

#include "base/numbers.h"
#include "mesh/border/face_border.h"
#include "mesh/mesh.h"
#include "mesh/proof/triangle_bound.h"

#include <functional>

namespace nrb::mesh {

struct MeshRule {
    double chord = infinity; // the largest distance, both ways
};

// What is to be meshed.
struct MeshDomain {
    const Spline *surface = nullptr;
    FaceBorder border{}; // its points are numbers of points of the mesh
    std::array<bool, 2> closed{};
    std::array<std::array<bool, 2>, 2> collapsed{}; // end 0 or 1 of axis k
    // Whether a place is inside, and whether curves of the border come into a rectangle; empty: all of the domain is.
    std::function<bool(const face::Point2 &)> inside{};
    std::function<bool(const Rectangle &)> cut{};
};

// Adds points, vertices and triangles to a mesh that has the points of the border, and tells how far they are from it.
MeshFace add_mesh(const MeshDomain &domain, const MeshRule &rule, Mesh &mesh);

} // namespace nrb::mesh
