// SPDX-License-Identifier: MIT
// The edges of a model as polylines, each once for all faces that share it.
#pragma once

#include "mesh/border/edge_uses.h"
#include "mesh/polyline/polyline.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace nrb::mesh {

struct EdgeLine {
    int64_t edge = -1;             // number in the model; -1: only one face has it
    std::vector<int32_t> points{}; // from the start of the edge to its end
    std::vector<double> params{};  // of these points, on the edge
    double bound = 0;              // of the Hausdorff distance from the edge
    // Whether each segment is proven to keep to the rule, before points are moved to those of other edges:
    // that only `bound` takes into account.
    bool reached = true;
};

// A vertex of the polyline of an edge, as one face has it on its curve in the domain.
struct CurveVertex {
    double param; // on the curve
    int32_t point;
    double edge_param;                   // on the edge
    std::optional<face::Point2> place{}; // in the domain, if the vertex has to be exactly there
};

class ModelEdges {
public:
    // Each segment is within the chord error of the rule of its part of the edge, as proven, and, as samples
    // show, of what the faces have there: the images of their curves, and of the segments between the same
    // places of their domains. There are also vertices where curves cross a seam, into the next copy of a
    // domain, and where a surface may have a kink.
    ModelEdges(const model::Model &model, const PolylineRule &rule);

    [[nodiscard]] const std::vector<Vector3> &points() const noexcept { return points_; }
    [[nodiscard]] const std::vector<EdgeLine> &lines() const noexcept { return lines_; }
    [[nodiscard]] double chord() const noexcept { return uses_.chord(); } // of the rule
    // The vertices on a curve of a face, with rising parameters.
    [[nodiscard]] const std::vector<CurveVertex> &vertices(int64_t face, int32_t loop,
                                                           int32_t index) const noexcept {
        return vertices_[uses_.at(face, loop, index)];
    }

    // The vertices on the segment of the domain that closes the gap after a curve; empty if there is no gap.
    [[nodiscard]] const std::vector<CurveVertex> &vertices_behind(int64_t face, int32_t loop,
                                                                  int32_t index) const noexcept;
    // The polyline under that segment. Precondition: there is a gap.
    [[nodiscard]] int64_t line_behind(int64_t face, int32_t loop, int32_t index) const noexcept;
    // The polyline under a curve of a face.
    [[nodiscard]] int64_t line_of(int64_t face, int32_t loop, int32_t index) const noexcept {
        return static_cast<int64_t>(uses_[uses_.at(face, loop, index)].line);
    }
    // Adds vertices to a polyline at rising parameters, except where it has one up to rounding, and further
    // ones where parts of a divided segment do not keep to the rule. Returns the faces that have the new
    // vertices. Points keep their numbers.
    std::vector<int64_t> add_vertices(int64_t number, std::span<const double> params);
    // Replaces the second point of each pair by the first one: a face cannot tell them apart. Returns the
    // faces that had replaced points.
    std::vector<int64_t> unite(const std::vector<std::array<int32_t, 2>> &pairs);

private:
    void make_line(size_t line);
    [[nodiscard]] std::vector<double> distances_of(size_t line, const std::vector<double> &params) const;
    void set_points(size_t number, const Polyline &polyline);
    int32_t end_of_line(size_t line, bool upper, const Vector3 &x);
    int32_t corner(int64_t number, const Vector3 &x);
    std::vector<int64_t> update_users(size_t line);
    void set_vertices(size_t number);
    [[nodiscard]] CurveVertex vertex_of(size_t number, double param, int32_t point) const;

    PolylineRule rule_;
    EdgeUses uses_;
    std::vector<EdgeLine> lines_;
    std::vector<std::vector<CurveVertex>> vertices_; // of the uses
    std::vector<Vector3> points_;
    // Points by the corners of SharedBorders, and by -1 - i for the end of curve number i at a gap.
    std::map<int64_t, int32_t> corners_;
};

} // namespace nrb::mesh
