// SPDX-License-Identifier: MIT
// Cubic pieces of curves along arcs of levels, each with a proven bound of its distance.
#pragma once

#include "intersect/levels/curves/piece_bounds.h"
#include "intersect/levels/curves/sample_kernel.h"
#include "intersect/levels/fields/level_field.h"
#include "intersect/levels/trace/level_boxes.h"

namespace nrb::intersect {

// Control points over a length of the parameter: parameters of the surface, and points in the frame of its pieces.
struct LevelSegment {
    double length = 0;
    std::array<std::array<double, 2>, 4> on{};
    std::array<std::array<double, 3>, 4> space{};
    double deviation = 0; // of both, in space, from the level
    // At Chebyshev points: the largest |f w|, and |w (C - S)| of both curves; less than 0: not known.
    double largest_value = -1, largest_gap = -1;
};

// With points, and tangents of length 1 in space, at both ends (Hermite). The function along such a piece, and the
// difference of the curve in space from the surface over the one in the parameter domain, are polynomials in the
// parameter; of degree n they are at most 1 + 2 / pi log(n + 1) times as large as at n + 1 Chebyshev points
// (H. Ehlich & K. Zeller, Math. Z. 93 (1966)). The curve in the parameter domain stays in the box of its arc, in which
// the level is a graph over one coordinate: where f changes along the other one by at least s, the level is within
// |f| / s of a place, along that axis, and in the box.
class ArcFitter {
public:
    // tolerance: in the frame.
    ArcFitter(LevelField &field, double tolerance);

    void fit(const LevelArc &arc, std::vector<LevelSegment> &segments);

private:
    struct Node {
        std::array<double, 2> place, tangent_on;
        std::array<double, 3> point, tangent;
    };
    // Where a segment may be, and what holds there.
    struct Room {
        std::array<Interval, 2> box;
        PartBounds bounds;
        int depth = 0;
        bool own = false; // of the segment alone
    };

    void set_piece(int64_t piece);
    [[nodiscard]] Room room_of(const LevelArc &arc) const;
    [[nodiscard]] Room part_of(const Room &room, const Node &a, const Node &b, const Interval &aside) const;
    [[nodiscard]] Node node(const std::array<double, 2> &place);
    [[nodiscard]] Node node_between(const Room &room, const Node &a, const Node &b, double share);
    void fit_between(const Node &a, const Node &b, const Room &room, const LevelSegment *sampled,
                     std::vector<LevelSegment> &segments);
    void divide(const Node &a, const Node &b, const Room &room, const LevelSegment &segment,
                std::vector<LevelSegment> &segments);
    [[nodiscard]] LevelSegment hermite(const Node &a, const Node &b, const Room &room) const noexcept;
    // How far a segment is from the level along the axis aside; sets its deviation.
    double set_deviation(const Room &room, LevelSegment &segment);
    [[nodiscard]] double rounding(const PartBounds &bounds) const noexcept;
    // How far the level may be from places at which |f w| is no larger, along the axis aside.
    [[nodiscard]] double away_at(const Room &room, double value) const noexcept;
    [[nodiscard]] bool is_good(const Room &room, const LevelSegment &segment) const noexcept;
    void sample(LevelSegment &segment) noexcept;
    void evaluate(const std::array<double, 2> &place, int order);

    LevelField &field_;
    const pieces::PieceGrid &grid_;
    std::array<int, 2> degrees_{}; // of the surface
    double tolerance_;
    CubicSamples samples_;
    double factor_ = 1;
    int64_t piece_ = -1;
    PieceDomain domain_{};
    LevelNet net_;
    PieceBounds bounds_;
    std::optional<std::array<double, 4>> form_;
    std::vector<double> patch_, work_, record_, sampling_;
    size_t axis_ = 0; // that of the present arc
    int left_ = 0;    // segments that it may still have
};

} // namespace nrb::intersect
