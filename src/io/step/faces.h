// SPDX-License-Identifier: MIT
// Reads faces with the edges and loops that bound them.
#pragma once

#include "io/step/geometry/geometry.h"
#include "model/model.h"

#include <vector>

namespace nrb::io::step {

// An edge of the file, and its counterpart in the model.
struct EdgeSource {
    int64_t number;          // of the instance
    int64_t geometry;        // of its curve
    model::CurvePiece piece; // of that curve, from the first vertex to the second
    int64_t index;           // in the model
};

// The edges that have been read, in ascending order of their numbers.
class EdgeSources {
public:
    void add(EdgeSource edge) { edges_.push_back(std::move(edge)); }
    // Null for an edge that is not known.
    [[nodiscard]] const EdgeSource *find(int64_t number) const noexcept;

private:
    std::vector<EdgeSource> edges_;
};

// What the face of an instance is made of. The inside is to the left of the loops about the normal of the
// surface itself, even if the outer normal of the face is the opposite one.
struct FaceSource {
    model::SurfaceShapePtr shape;
    face::FaceParts parts;
    bool against;    // whether the outer normal is opposite to that of the surface
    double distance; // of the spline from the surface; 0: exact but for rounding
};

// Curves in the domain are taken from the file only if the surface is a spline there and they lie under their
// edges. All others are left to be made. Throws Status::syntax, unsupported, and what reading the surface
// throws.
FaceSource read_face(Geometry &geometry, const EdgeSources &sources, const std::vector<model::Edge> &edges,
                     const Instance &face, double tolerance);

} // namespace nrb::io::step
