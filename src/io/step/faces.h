// SPDX-License-Identifier: MIT
// Faces with the edges and loops that bound them.
#pragma once

#include "io/step/geometry/geometry.h"
#include "model/model.h"

#include <vector>

namespace nrb::io::step {

// An edge of the file, and where the model has it.
struct EdgeSource {
    int64_t number;          // of the instance
    int64_t geometry;        // of its curve
    model::CurvePiece piece; // of that curve, from the first vertex to the second
    int64_t index;           // in the model
};

// Those that have been read, by rising numbers.
class EdgeSources {
public:
    void add(EdgeSource edge) { edges_.push_back(std::move(edge)); }
    // Null for an edge that is not known.
    [[nodiscard]] const EdgeSource *find(int64_t number) const noexcept;

private:
    std::vector<EdgeSource> edges_;
};

// What the face of an instance is made of. Loops run with the inside to the left of the surface's own normal, whatever side the
// face has outside.
struct FaceSource {
    model::SurfaceShapePtr shape;
    face::FaceParts parts;
    bool against;    // the outer normal is against that of the surface
    double distance; // of the spline from the surface
};

// Curves in the domain that the file gives are taken for surfaces that are splines in the file, where they lie under their edges;
// all others are left to be made. Throws Status::syntax, unsupported, and what the surface does.
FaceSource read_face(Geometry &geometry, const EdgeSources &sources, const std::vector<model::Edge> &edges,
                     const Instance &face, double tolerance);

} // namespace nrb::io::step
