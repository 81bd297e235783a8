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
    int64_t edge = -1;             // of the model; -1: one of a face alone
    std::vector<int32_t> points{}; // from its start to its end
    std::vector<double> params{};
    double bound = 0; // of its distance from the curve, both ways
    bool reached = true;
};

// A vertex of the polyline of an edge, on the curve of a face in its domain.
struct CurveVertex {
    double param;
    int32_t point;
    double edge_param;                   // of the edge
    std::optional<face::Point2> place{}; // if it has to be there exactly, in the domain
};

class ModelEdges {
public:
    // Segments are within the distance of the rule of their edges, and so are, about, what the faces make of the segments between
    // the same places of their domains. Vertices are also where curves pass from one copy of a domain to the next, and
    // where a surface may have a kink.
    ModelEdges(const model::Model &model, const PolylineRule &rule);

    [[nodiscard]] const std::vector<Vector3> &points() const noexcept { return points_; }
    [[nodiscard]] const std::vector<EdgeLine> &lines() const noexcept { return lines_; }
    [[nodiscard]] double chord() const noexcept { return uses_.chord(); } // of the rule
    // Of a curve of a face: rising.
    [[nodiscard]] const std::vector<CurveVertex> &vertices(int64_t face, int32_t loop,
                                                           int32_t index) const noexcept {
        return vertices_[uses_.at(face, loop, index)];
    }

    // Of the segment of the domain by which a loop goes on behind a curve whose end is far from the next one: empty if there is none.
    [[nodiscard]] const std::vector<CurveVertex> &vertices_behind(int64_t face, int32_t loop,
                                                                  int32_t index) const noexcept;
    [[nodiscard]] int64_t line_behind(int64_t face, int32_t loop, int32_t index) const noexcept;
    // The polyline under a curve of a face.
    [[nodiscard]] int64_t line_of(int64_t face, int32_t loop, int32_t index) const noexcept {
        return static_cast<int64_t>(uses_[uses_.at(face, loop, index)].line);
    }
    // Further vertices of the polyline of a number, at rising parameters, unless it has one there, to rounding; the faces that have
    // them. Points keep their numbers.
    std::vector<int64_t> add_vertices(int64_t number, std::span<const double> params);
    // Of each pair the first point in place of the second one, which a face cannot tell from it; the faces that have these.
    std::vector<int64_t> unite(const std::vector<std::array<int32_t, 2>> &pairs);

private:
    void make_line(size_t line, const PolylineRule &rule);
    [[nodiscard]] std::vector<double> distances_of(size_t line, const std::vector<double> &params) const;
    void set_points(size_t line, const Polyline &polyline);
    int32_t end_of_line(size_t line, bool upper, const Vector3 &x);
    int32_t corner(int64_t number, const Vector3 &x);
    std::vector<int64_t> update_users(size_t line);
    int32_t add_point(size_t line, double param);
    void set_vertices(size_t number);
    [[nodiscard]] CurveVertex vertex_of(size_t number, double param, int32_t point) const;

    EdgeUses uses_;
    std::vector<EdgeLine> lines_;
    std::vector<std::vector<CurveVertex>> vertices_; // of the uses
    std::vector<Vector3> points_;
    std::map<int64_t, int32_t> corners_;
};

} // namespace nrb::mesh
