// SPDX-License-Identifier: MIT
// Triangle meshes of shapes, with proven bounds of their deviation both ways; the data types of the result.
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

// The limits that a mesh is asked to keep.
struct MeshRule {
    double chord = infinity; // largest deviation (chord error), both ways
    // The same as a share of the longest side of the box of all control points; 0: no limit.
    double relative = 0;
    double longest = 0;     // longest side of a triangle; 0: no limit
    double angle = 0;       // largest angle between the normals at the corners of a triangle; 0: no limit
    double least_angle = 0; // smallest angle of triangles away from the border; 0: no limit
};

// A point as a face has it, with parameters and a normal. A point on an edge, a crease or a seam has several
// vertices.
struct MeshVertex {
    int32_t point;
    std::array<double, 2> param;
    Vector3 normal; // of the surface, as the limit from within the face; NaN where there is none
};

// The mesh of a face, of a whole surface, or of a volume, which has no triangles.
struct MeshFace {
    size_t first_vertex = 0, vertices = 0;
    size_t first_triangle = 0, triangles = 0;
    double from_shape = 0; // no point of the face is farther than this from the triangles
    double from_mesh = 0;  // no point of the triangles is farther than this from the face
    bool reached = true;   // the whole rule is proven to be met
    // From the model file.
    std::string name{};
    int64_t part = 0;
    std::optional<std::array<double, 3>> colour{}; // red, green, blue from 0 to 1
    bool turned = false; // whether the normal of the surface points away from the outside
};

// The polyline of an edge. All faces at the edge share its points.
struct MeshEdge {
    int64_t edge = -1;            // number in the model; -1: only one face has it
    size_t first = 0, points = 0; // in Mesh::edge_points
    double bound = 0;             // of the Hausdorff distance of the polyline and the edge
    bool reached = true;
};

// A cell of a grid over a volume, with its corners in the order of VTK, and what is known about the sign of
// the Jacobian determinant of the volume in it.
struct MeshHexahedron {
    std::array<int32_t, 8> corners; // numbers of points
    int8_t fold;                    // one of the constants of analysis/folds.h
    int8_t sign;                    // of the determinant where there is no fold; 0: it vanishes
};

// Faces are in the order of the model, each in the coordinates of its part.
struct Mesh {
    std::vector<Vector3> points; // z = 0 in the plane
    std::vector<MeshVertex> vertices;
    // Numbers of vertices, counterclockwise about the normal of the surface.
    std::vector<std::array<int32_t, 3>> triangles;
    // For each triangle, whether it and the next one are the two halves of a cell; empty: none is.
    std::vector<bool> paired{};
    std::vector<MeshFace> faces;
    std::vector<MeshEdge> edges;
    std::vector<int32_t> edge_points{};
    std::vector<MeshHexahedron> hexahedra{};    // the last axis fastest
    std::array<std::vector<double>, 3> lines{}; // parameters of the grid, from end to end of each axis
    // From the model: what it takes to place its parts in the whole.
    double metres_per_unit = 0; // 0: not known
    std::vector<model::ModelPart> parts{};
    std::vector<model::Use> uses{};
};
using MeshPtr = std::shared_ptr<const Mesh>;

} // namespace nrb::mesh
