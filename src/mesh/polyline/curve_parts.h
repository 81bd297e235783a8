// SPDX-License-Identifier: MIT
// A curve as Bezier pieces in a frame: its points, the places where a polyline needs a vertex, and how well a
// segment approximates a part of it.
#pragma once

#include "mesh/polyline/chord.h"
#include "mesh/polyline/polyline.h"

#include <optional>
#include <vector>

namespace nrb::mesh {

// A point of the curve; where the curve jumps, the limit from the left or from the right.
struct Vertex {
    double t = 0;
    std::vector<double> point;    // as evaluation returns it
    std::vector<double> in_frame; // the same
};

// A segment that stands for a part of the curve.
struct Segment {
    double bound = 0;      // on the Hausdorff distance, in the caller's unit
    double need = 0;       // about how many segments the rule takes for this part
    bool proven = true;    // whether it is proven to keep to the rule
    bool hopeless = false; // it does not keep to it, and no parts of it could be proven to

    [[nodiscard]] bool fits() const noexcept { return need <= 1; }
    [[nodiscard]] bool stays() const noexcept { return fits() || hopeless; }
};

// A place between pieces that needs a vertex.
struct Corner {
    double t;
    bool jump; // else a kink, or a gap no larger than rounding
};

class CurveParts {
public:
    CurveParts(const Spline &curve, const PolylineRule &rule);

    [[nodiscard]] const Spline &curve() const noexcept { return curve_; }
    // Jumps, and breaks at which the direction changes by more than rounding or is unknown. The ends of the
    // domain are not among them.
    [[nodiscard]] std::vector<Corner> corners() const;
    // Whether the curve ends where it begins, up to rounding.
    [[nodiscard]] bool closed() const;
    [[nodiscard]] Vertex vertex(double t, bool left) const;
    // The segment between two vertices, from.t < to.t, without a jump in between. Cost: linear in the number
    // of pieces in between.
    [[nodiscard]] Segment segment(const Vertex &from, const Vertex &to);

private:
    struct Sizes { // of a segment
        double bound = 0, floor = 0, turning = 0, extent = 0;
        bool hidden = true; // whether all of it may be due to rounding, which could have made every weight 0
    };

    // The corner at the start of piece e > 0, if there is one.
    [[nodiscard]] std::optional<Corner> corner(size_t e) const;
    // Whether the limits from the left and from the right are one point, up to rounding.
    [[nodiscard]] bool meet(const Vertex &before, const Vertex &after) const;
    [[nodiscard]] bool smooth(size_t e) const;
    // The piece that contains t; at a break, the later or the earlier one.
    [[nodiscard]] size_t piece_at(double t) const noexcept;
    [[nodiscard]] size_t piece_before(double t) const noexcept;
    [[nodiscard]] Sizes sizes(const Vertex &from, const Vertex &to);
    void add(const pieces::BezierPiece &piece, Sizes &sizes);

    const Spline &curve_;
    PolylineRule rule_;
    pieces::Frame frame_;
    std::vector<pieces::BezierPiece> pieces_;
    std::vector<double> starts_; // of the pieces
    double chord_, longest_;     // of the rule, in the frame
    Chord segment_;
};

} // namespace nrb::mesh
