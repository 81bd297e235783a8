// SPDX-License-Identifier: MIT
// The model, a boundary representation: faces with shared edges and vertices, the parts to which they belong
// and their placements, and the splines and notes that a file has besides.
#pragma once

#include "base/error.h"
#include "base/lazy.h"
#include "face/face.h"
#include "model/shapes/surface_shape.h"
#include "spline/spline.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace nrb::model {

struct NamedSpline {
    std::string name;
    SplinePtr spline;
    std::vector<int64_t> layers{}; // of the model, ascending
};

// A note on an entity of a file that was not read, or not as stated, and the reason. `line`: where the file
// has it.
struct Note {
    int entity_type;
    int64_t line;
    Status reason;
    std::string text;
};

// A place in a loop of a face where an edge is used.
struct EdgeUse {
    int64_t face;
    int64_t loop;
    int64_t index; // in the loop
};

// An edge. Its curve runs from its first vertex to its second one.
struct Edge {
    SplinePtr curve;
    CurveShapePtr shape;                     // null: only the spline is known
    std::array<int64_t, 2> vertices{-1, -1}; // -1: not known
    std::vector<EdgeUse> uses{};
    int64_t part = 0;
};

struct ModelFace {
    std::string name;
    face::FacePtr face;
    SurfaceShapePtr shape; // null: only the spline is known
    bool against = false;  // whether the outer normal is opposite to that of the surface
    int64_t part = 0;
    std::optional<std::array<double, 3>> colour; // red, green, blue from 0 to 1
    int64_t solid = -1;                          // the number of the solid that it bounds; -1: none
    // Whether it belongs to the shell of a void in the solid. Its outer normal, too, points out of the
    // material.
    bool in_void = false;
    std::vector<int64_t> layers{}; // of the model, ascending
};

// Faces and edges with a common coordinate system, which are placed together.
struct ModelPart {
    std::string name;
};

// A placement of a part in another part, or in the whole if `parent` is -1: x is placed at M x + t, where
// `placement` holds the rows of (M | t).
struct Use {
    int64_t parent = -1;
    int64_t part = 0;
    std::array<double, 12> placement{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    std::string name;
};

struct Model {
    std::vector<NamedSpline> splines; // those that belong to no face and no edge
    std::vector<Note> notes;
    double metres_per_unit = 0; // 0: not known
    std::vector<ModelPart> parts{};
    std::vector<Use> uses{};
    std::vector<ModelFace> faces{};
    std::vector<Edge> edges{};
    std::vector<Vector3> vertices{};
    std::vector<std::string> layers{}; // names of layers, each with a face or a spline in it
    OwnTable rays{}, closed_rays{};    // scenes of rays/scene.h
};
using ModelPtr = std::shared_ptr<const Model>;

inline void check_metres(double metres) {
    if (!std::isfinite(metres) || metres < 0) {
        fail(Status::factor, "metres = %s, expected a finite value >= 0", Number(metres).text);
    }
}

} // namespace nrb::model
