// SPDX-License-Identifier: MIT
// Edges, and what bounds a face.
#pragma once

#include "io/step/geometry/geometry.h"
#include "io/step/geometry/placements.h"
#include "model/shapes/surface_spline.h"

#include <string>
#include <vector>

namespace nrb::io::step {

// The name of a representation item; "#12" if it has none.
std::string name_of(const Instances &instances, const Instance &instance);

// The point of a VERTEX_POINT that an attribute names.
Point read_vertex(Geometry &geometry, int64_t number, const Attributes &owner, const char *attribute);

// The curve of an edge from its start to its end.
model::CurvePiece read_edge(Geometry &geometry, const Instance &edge);

// Splines of the edges that have been read, for the faces that they bound.
class EdgeSplines {
public:
    // Edges come in the order of their numbers; null: the edge could not be read.
    void add(int64_t number, SplinePtr spline) { edges_.push_back({number, std::move(spline)}); }
    void set_last(SplinePtr spline) { edges_.back().spline = std::move(spline); }
    // Null for an edge that could not be read and for one that is not known.
    [[nodiscard]] const Spline *find(int64_t number) const noexcept;

private:
    struct Edge {
        int64_t number;
        SplinePtr spline;
    };
    std::vector<Edge> edges_;
};

// Points whose hull contains the boundary of a face: the control points of its edges, its vertices, and the corners of
// its polygons. Throws Status::syntax, and unsupported where an edge could not be read.
std::vector<Vector3> boundary_points(Geometry &geometry, const EdgeSplines &edges, const Instance &face);

// The same of a curve-bounded surface.
std::vector<Vector3> outline_points(Geometry &geometry, const Instance &surface);

} // namespace nrb::io::step
