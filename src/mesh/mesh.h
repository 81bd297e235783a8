// SPDX-License-Identifier: MIT
// Triangles that stand for shapes, with the proof of how far they are from them.
#pragma once

#include "base/numbers.h"
#include "model/model.h"
#include "numeric/vector3.h"
#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nrb::mesh {

// What is asked for.
struct MeshRule {
    double chord = infinity; // the largest distance, both ways
    double relative =
        0; // the same as a share of the largest side of the box of all control points; 0: no limit
    double longest = 0;     // side of a triangle; 0: no limit
    double angle = 0;       // between the normals at the corners of a triangle; 0: no limit
    double least_angle = 0; // of triangles inside; 0: no limit
};

// Where a face has a point: on a border of faces, at a crease or a seam a point has several.
struct MeshVertex {
    int32_t point;
    std::array<double, 2> param;
    Vector3 normal; // of the surface, from the side of the face; NaN where there is none
};

// What stands for a face, or a whole surface.
struct MeshFace {
    size_t first_vertex = 0, vertices = 0;
    size_t first_triangle = 0, triangles = 0;
    double from_shape = 0; // no point of the face is farther from the triangles
    double from_mesh = 0;  // no point of the triangles is farther from the face
    bool reached = true;   // all that was asked for is proven
    // What files say of it.
    std::string name{};
    int64_t part = 0;
    std::optional<std::array<double, 3>> colour{}; // red, green, blue from 0 to 1
    bool turned = false; // whether the outside is where the normal of the surface does not point
};

// The polyline of an edge, whose points all faces at it have.
struct MeshEdge {
    int64_t edge = -1; // of the model; -1: one of a face alone
    size_t first = 0, points = 0;
    double bound = 0; // no point of the one is farther from the other
    bool reached = true;
};

// The cell of a grid over a volume, with corners in the order of VTK, and what is known of the sign of the Jacobian of the volume in it.
struct MeshHexahedron {
    std::array<int32_t, 8> corners; // points
    int8_t fold;                    // one of the constants of analysis/folds.h
    int8_t sign;                    // that of the determinant where there is no fold, 0: it vanishes
};

// Faces are in the order of those of the model, in the coordinates of their parts.
struct Mesh {
    std::vector<Vector3> points; // z = 0 in the plane
    std::vector<MeshVertex> vertices;
    std::vector<std::array<int32_t, 3>>
        triangles;              // of vertices, counterclockwise about the normal of the surface
    std::vector<bool> paired{}; // of each triangle: it and the next one are all of a cell; empty: none are
    std::vector<MeshFace> faces;
    std::vector<MeshEdge> edges;
    std::vector<int32_t> edge_points{};
    std::vector<MeshHexahedron> hexahedra{};    // the last axis fastest
    std::array<std::vector<double>, 3> lines{}; // of the grid, from end to end of each axis of the volume
    // Of the model: what it takes to put its parts into the whole.
    double metres_per_unit = 0; // 0: not known
    std::vector<model::ModelPart> parts{};
    std::vector<model::Use> uses{};
};
using MeshPtr = std::shared_ptr<const Mesh>;

} // namespace nrb::mesh
