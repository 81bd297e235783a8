// SPDX-License-Identifier: MIT
// Triangulates the part of a surface that polygons in its parameter domain bound, within proven distances.
#pragma once

#include "base/numbers.h"
#include "mesh/border/face_border.h"
#include "mesh/mesh.h"
#include "mesh/proof/triangle_bound.h"

#include <functional>

namespace nrb::mesh {

// What a mesh asks for at its border.
struct BorderWish {
    // Segments whose triangles are over a limit, each with the number of parts into which it is best divided.
    std::vector<std::pair<int32_t, int>> weak{};
    // Segments that cross others.
    std::vector<int32_t> crossed{};
    // Segments that pass through other places of the triangulation, and where: as shares of their lengths.
    std::vector<std::pair<int32_t, double>> touched{};
    // Pairs of points that are to be one: the first replaces the second.
    std::vector<std::array<int32_t, 2>> united{};
};

// What is to be meshed: a surface, or the part of it inside a border.
struct MeshDomain {
    const Spline *surface = nullptr;
    FaceBorder border{};
    const std::vector<Vector3> *points = nullptr;   // in space, by the numbers in the border
    std::array<bool, 2> closed{};                   // whether the two ends of axis k are one curve
    std::array<std::array<bool, 2>, 2> collapsed{}; // whether end 0 or 1 of axis k is a single point
    // Whether triangles at the border are to be as fat as possible in space, not in the metric in which cells
    // are square.
    bool in_space = false;
    // Whether a place is inside, and whether curves of the border enter a rectangle. Empty: all of the domain
    // is inside.
    std::function<bool(const face::Point2 &)> inside{};
    std::function<bool(const Rectangle &)> cut{};
    // Changes the border and the points of this domain as wished; points keep their numbers. Returns whether
    // anything changed. Empty: the border is fixed.
    std::function<bool(const BorderWish &)> change_border{};
};

// The point of a vertex is a number among the points of the domain, or, where it is negative, -1 - i for
// points[i] of this mesh.
struct DomainMesh {
    std::vector<Vector3> points;
    std::vector<MeshVertex> vertices;
    std::vector<std::array<int32_t, 3>> triangles;
    std::vector<bool> paired{}; // as in Mesh
    double from_shape = 0, from_mesh = 0;
    bool reached = false;
};

DomainMesh mesh_of(const MeshDomain &domain, const MeshRule &rule);

} // namespace nrb::mesh
