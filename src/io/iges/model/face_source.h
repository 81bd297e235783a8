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
    bool whole_domain = false; // the boundary of the domain is one of the face
    bool mirrored = false;     // the normal of the shape is against that of the entity's parameters
    double distance = 0;       // of the spline from the surface, at most
};

// With the curves in the parameters of the spline; a surface without ends is cut to what its loops and `poles` need. Throws what
// the making of its spline does.
FaceSource make_source(Geometry &geometry, const Surface &surface, std::vector<LoopSource> loops,
                       bool whole_domain, const std::vector<Vector3> &poles);

// An edge that no other face has.
struct OwnEdge {
    model::CurveShapePtr shape; // null: nothing is known but the spline
    size_t loop;
};

struct MadeParts {
    face::FaceParts parts;
    std::vector<OwnEdge> own; // their keys follow each other
};

// Of curves that rule, those of the other kind are taken where they belong to them, to the tolerance, and are left to be made
// where they do not. `second`: with the rule against the preference of the file. Own edges have keys from `first_key` on.
MadeParts parts_of(const FaceSource &source, bool second, double tolerance, int64_t first_key);

// Whether the rule makes a difference.
bool has_two_ways(const FaceSource &source) noexcept;

} // namespace nrb::io::iges
