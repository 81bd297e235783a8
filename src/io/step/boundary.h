// SPDX-License-Identifier: MIT
// Reads edges, and the points that bound a face.
#pragma once

#include "io/step/geometry/geometry.h"
#include "io/step/geometry/placements.h"
#include "model/shapes/surface_spline.h"

#include <string>
#include <vector>

namespace nrb::io::step {

// The name of a representation item, or "#12" if it has none.
std::string name_of(const Instances &instances, const Instance &instance);

// The point of a VERTEX_POINT that an attribute names.
Point read_vertex(Geometry &geometry, int64_t number, const Attributes &owner, const char *attribute);

// The piece of a curve that is the edge, from its start to its end.
model::CurvePiece read_edge(Geometry &geometry, const Instance &edge);

// The splines of the edges that have been read, for the faces that they bound.
class EdgeSplines {
public:
    // Edges have to be added in ascending order of their numbers. Null: the edge could not be read.
    void add(int64_t number, SplinePtr spline) { edges_.push_back({number, std::move(spline)}); }
    void set_last(SplinePtr spline) { edges_.back().spline = std::move(spline); }
    // Null for an edge that could not be read, or is not known.
    [[nodiscard]] const Spline *find(int64_t number) const noexcept;

private:
    struct Edge {
        int64_t number;
        SplinePtr spline;
    };
    std::vector<Edge> edges_;
};

// Points whose convex hull contains the boundary of a face: the control points of its edges, its vertices,
// and the corners of its polygons. Throws Status::syntax, and unsupported if an edge could not be read.
std::vector<Vector3> boundary_points(Geometry &geometry, const EdgeSplines &edges, const Instance &face);

// The same for a curve-bounded surface.
std::vector<Vector3> outline_points(Geometry &geometry, const Instance &surface);

} // namespace nrb::io::step
