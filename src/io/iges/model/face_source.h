// SPDX-License-Identifier: MIT
// What the faces of a file are made of.
#pragma once

#include "face/face.h"
#include "io/iges/model/loops.h"

#include <vector>

namespace nrb::io::iges {

struct FaceSource {
    model::SurfaceShapePtr shape;
    SplinePtr surface;
    std::vector<LoopSource> loops;
    bool whole_domain = false; // the boundary of the domain bounds the face
    bool mirrored = false;     // the normal of the shape is opposite to that of the parameters of the entity
    double distance = 0;       // upper bound of the distance of the spline from the surface
};

// Makes the spline of the surface and converts the curves to its parameters; an unbounded surface is cut to
// what its loops and `poles` need. Throws what making the spline throws.
FaceSource make_source(Geometry &geometry, const Surface &surface, std::vector<LoopSource> loops,
                       bool whole_domain, const std::vector<Vector3> &poles);

// An edge that belongs to one face only.
struct OwnEdge {
    model::CurveShapePtr shape; // null: only the spline is known
    size_t loop;
};

struct MadeParts {
    face::FaceParts parts;
    std::vector<OwnEdge> own; // with consecutive keys
};

// The surface and the loops of a face. Each loop is defined either by its curves in space or by those in the
// domain, as the file prefers or, with `second`, the other way. The curves of the other kind are used where
// they agree within the tolerance, and are left to be made where they do not. Own edges have keys from
// `first_key` on.
MadeParts parts_of(const FaceSource &source, bool second, double tolerance, int64_t first_key);

// Whether `second` makes a difference.
bool has_two_ways(const FaceSource &source) noexcept;

} // namespace nrb::io::iges
