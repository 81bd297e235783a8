// SPDX-License-Identifier: MIT
// Triangles that stand for shapes, with the proof of how far they are from them.
#pragma once

#include "numeric/vector3.h"
#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace nrb::mesh {

// Where a face has a point: on a border of faces, at a crease or a seam a point has several.
struct MeshVertex {
    int32_t point;
    std::array<double, 2> param;
    Vector3 normal; // NaN where there is none
};

// What stands for a face, or a whole surface.
struct MeshFace {
    int64_t face = 0;                     // of a model
    size_t first_vertex = 0, vertices = 0;
    size_t first_triangle = 0, triangles = 0;
    double from_shape = 0; // no point of the face is farther from the triangles
    double from_mesh = 0;  // no point of the triangles is farther from the face
    bool reached = true;   // all that was asked for is proven
};

struct Mesh {
    std::vector<Vector3> points;
    std::vector<MeshVertex> vertices;
    std::vector<std::array<int32_t, 3>> triangles; // of vertices, counterclockwise about the normal of the surface
    std::vector<MeshFace> faces;
};
using MeshPtr = std::shared_ptr<const Mesh>;

} // namespace nrb::mesh
