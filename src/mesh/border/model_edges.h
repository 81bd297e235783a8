// SPDX-License-Identifier: MIT
// The edges of a model as polylines, each once for all faces that share it.
#pragma once

#include "face/border_pieces.h"
#include "mesh/border/curve_pairing.h"
#include "mesh/border/snap_lines.h"
#include "mesh/polyline/polyline.h"
#include "model/model.h"
#include "model/sections/shared_borders.h"

#include <map>
#include <memory>
#include <optional>
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

// What edges of a model are before they are polylines, for all distances: which curves are under which, and these in space.
struct EdgeCurves {
    explicit EdgeCurves(const model::Model &model);

    struct Line {
        int64_t edge = -1; // as of an EdgeLine
        SplinePtr curve;
        std::vector<size_t> users{}; // curves of loops
    };
    model::SharedBorders borders;
    std::vector<Line> lines;
    std::vector<size_t> line_of{}; // each curve of a loop, by its number

private:
    static constexpr auto none = static_cast<size_t>(-1);
    [[nodiscard]] size_t &line(size_t curve);
    void add_line(const model::Edge &edge);
    void add_own_lines(const face::Face &face, const face::Loop &loop, size_t first);
};

class ModelEdges {
public:
    // Segments are within the distance of the rule of their edges, and so are, about, what the faces make of the segments between
    // the same places of their domains. Vertices are also where curves pass from one copy of a domain to the next, and
    // where a surface may have a kink.
    ModelEdges(const model::Model &model, const EdgeCurves &curves, const PolylineRule &rule);

    [[nodiscard]] const std::vector<Vector3> &points() const noexcept { return points_; }
    [[nodiscard]] const std::vector<EdgeLine> &lines() const noexcept { return lines_; }
    // Of a curve of a face: rising.
    [[nodiscard]] const std::vector<CurveVertex> &vertices(int64_t face, int32_t loop,
                                                           int32_t index) const noexcept {
        return uses_[static_cast<size_t>(borders_.number(face, loop, index))].vertices;
    }

    // Of the segment of the domain by which a loop goes on behind a curve whose end is far from the next one: empty if there is none.
    [[nodiscard]] const std::vector<CurveVertex> &vertices_behind(int64_t face, int32_t loop,
                                                                  int32_t index) const noexcept;
    [[nodiscard]] int64_t line_behind(int64_t face, int32_t loop, int32_t index) const noexcept;
    // The polyline under a curve of a face.
    [[nodiscard]] int64_t line_of(int64_t face, int32_t loop, int32_t index) const noexcept {
        return static_cast<int64_t>(uses_[use_at(face, loop, index)].line);
    }
    // A further vertex of a polyline, unless it has one there, to rounding; the faces that have it. Points keep their numbers.
    std::vector<int64_t> add_vertex(int64_t line, double param);
    // The first point in place of the second one, which a face cannot tell from it; the faces that have this one.
    std::vector<int64_t> unite(int32_t first, int32_t second);

private:
    struct Fixed {
        double curve, edge; // parameters
        face::Point2 place;
    };
    struct Use {
        int64_t face = 0;
        int32_t loop = 0, index = 0;
        size_t line = 0;
        SplinePtr own{}; // the curve, if it is none of the face
        std::unique_ptr<CurvePairing> pairing{};
        std::vector<Fixed> fixed{};
        std::vector<CurveVertex> vertices{};
    };

    void set_uses();
    void add_gaps(int64_t face);
    void add_gap(int64_t face, int32_t loop, int32_t index, const face::Joint &gap);
    void make_pairing(Use &use, double near);
    [[nodiscard]] const face::Coedge &coedge_of(const Use &use) const noexcept;
    void set_lines(const EdgeCurves &curves);
    void add_fixed(int64_t face);
    void fix_behind(const face::BorderPlace &place, bool turned, const LinePassage &passage);
    void fix(const face::BorderPlace &place, const face::Point2 &x);
    using FixedUse = std::pair<Fixed *, size_t>; // and of which use
    [[nodiscard]] static bool is_alone(const std::vector<FixedUse> &all, size_t i, double room);
    void align_fixed(size_t line);
    void make_line(size_t line, const PolylineRule &rule);
    [[nodiscard]] std::vector<double> fixed_params(size_t line) const;
    [[nodiscard]] std::vector<double> places_to_add(size_t line, const std::vector<double> &params,
                                                    double chord) const;
    void set_points(size_t line, const Polyline &polyline);
    void set_vertices(Use &use);
    [[nodiscard]] bool is_far(const Use &use, const std::array<double, 2> &params, double chord) const;
    int32_t end_of_line(size_t line, bool upper, const Vector3 &x);
    int32_t corner(int64_t number, const Vector3 &x);

    [[nodiscard]] size_t use_at(int64_t face, int32_t loop, int32_t index) const noexcept {
        return static_cast<size_t>(borders_.number(face, loop, index));
    }

    const model::Model &model_;
    int64_t face_ = 0; // at which we are
    const model::SharedBorders &borders_;
    std::vector<Use> uses_;
    std::vector<EdgeLine> lines_;
    std::vector<SplinePtr> curves_;          // of the lines
    std::vector<std::vector<size_t>> users_; // of the lines
    std::vector<Vector3> points_;
    std::map<int64_t, int32_t> corners_;
    std::map<int64_t, size_t> gaps_; // uses behind the uses of curves
};

} // namespace nrb::mesh
