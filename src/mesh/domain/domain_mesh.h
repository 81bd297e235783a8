// SPDX-License-Identifier: MIT
// The part of a surface that polygons in its domain bound, as triangles.
#pragma once

#include "base/numbers.h"
#include "mesh/border/face_border.h"
#include "mesh/mesh.h"
#include "mesh/proof/triangle_bound.h"

#include <functional>

namespace nrb::mesh {

// What a mesh wants of the border.
struct BorderWish {
    // Segments of the border at which triangles are too far off, and into how many parts they are best divided.
    std::vector<std::pair<int32_t, int>> weak{};
    // Segments that cross others.
    std::vector<int32_t> crossed{};
    // Segments of the border that go through other places, and where: shares of them.
    std::vector<std::pair<int32_t, double>> touched{};
    // Points of the border that are one: the first stands for the second.
    std::vector<std::array<int32_t, 2>> united{};
};

// What is to be meshed.
struct MeshDomain {
    const Spline *surface = nullptr;
    FaceBorder border{};
    const std::vector<Vector3> *points = nullptr; // of which those of the border are numbers
    std::array<bool, 2> closed{};
    std::array<std::array<bool, 2>, 2> collapsed{}; // end 0 or 1 of axis k
    bool in_space = false; // whether triangles at the border are to be as fat as that, not as cells are
    // Whether a place is inside, and whether curves of the border come into a rectangle; empty: all of the domain is.
    std::function<bool(const face::Point2 &)> inside{};
    std::function<bool(const Rectangle &)> cut{};
    // Changes the border and the points of this domain, where numbers of points stay. Returns whether it did. Empty: they are what
    // they are.
    std::function<bool(const BorderWish &)> change_border{};
};

// Points of vertices are those of the border, or own ones: -1 - i.
struct DomainMesh {
    std::vector<Vector3> points;
    std::vector<MeshVertex> vertices;
    std::vector<std::array<int32_t, 3>> triangles;
    std::vector<bool> paired{}; // as of a mesh
    double from_shape = 0, from_mesh = 0;
    bool reached = false;
};

DomainMesh mesh_of(const MeshDomain &domain, const MeshRule &rule);

} // namespace nrb::mesh
