// SPDX-License-Identifier: MIT
// What a file holds.
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
    std::vector<int64_t> layers{}; // of the model, rising
};

// An entity that did not become a spline, and why. `line` is where the file has it.
struct Note {
    int entity_type;
    int64_t line;
    Status reason;
    std::string text;
};

// A place in a face where an edge is used.
struct EdgeUse {
    int64_t face;
    int64_t loop;
    int64_t index; // in the loop
};

// The curve of an edge runs from its first vertex to its second one.
struct Edge {
    SplinePtr curve;
    CurveShapePtr shape;                     // null: nothing is known but the spline
    std::array<int64_t, 2> vertices{-1, -1}; // -1: none is known
    std::vector<EdgeUse> uses{};
    int64_t part = 0;
};

struct ModelFace {
    std::string name;
    face::FacePtr face;
    SurfaceShapePtr shape; // null: nothing is known but the spline
    bool against = false;  // whether the outer normal is against that of the surface
    int64_t part = 0;
    std::optional<std::array<double, 3>> colour; // red, green, blue from 0 to 1
    int64_t solid = -1;                          // the number of the solid that it bounds, -1: none
    bool in_void =
        false; // whether it is of a shell inside the solid; its outer normal points out of the material, too
    std::vector<int64_t> layers{}; // of the model, rising
};

// Faces and edges that are placed together, in coordinates of their own.
struct ModelPart {
    std::string name;
};

// A part in another one, or in the whole if that is -1: x is placed at M x + t, rows of (M | t) one after the other.
struct Use {
    int64_t parent = -1;
    int64_t part = 0;
    std::array<double, 12> placement{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    std::string name;
};

struct Model {
    std::vector<NamedSpline> splines; // of which no faces and edges consist
    std::vector<Note> notes;
    double metres_per_unit = 0; // 0: the file does not say
    std::vector<ModelPart> parts{};
    std::vector<Use> uses{};
    std::vector<ModelFace> faces{};
    std::vector<Edge> edges{};
    std::vector<Vector3> vertices{};
    std::vector<std::string> layers{}; // names of layers, each of which has a face or a spline
    OwnTable rays{}, closed_rays{};    // of rays/scene.h
};
using ModelPtr = std::shared_ptr<const Model>;

inline void check_metres(double metres) {
    if (!std::isfinite(metres) || metres < 0) {
        fail(Status::factor, "metres = %s, expected a finite value >= 0", Number(metres).text);
    }
}

} // namespace nrb::model
