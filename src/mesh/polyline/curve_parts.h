// SPDX-License-Identifier: MIT
// A curve as Bezier pieces in a frame: its points, places where a polyline needs a vertex, and what a segment is worth.
#pragma once

#include "mesh/polyline/chord.h"
#include "mesh/polyline/polyline.h"

#include <optional>
#include <vector>

namespace nrb::mesh {

// A place of the curve, from the left or the right where it jumps.
struct Vertex {
    double t = 0;
    std::vector<double> point;    // as evaluation returns it
    std::vector<double> in_frame; // the same
};

// A segment in place of a part of the curve.
struct Segment {
    double bound = 0;      // of the Hausdorff distance, in the unit of the caller
    double need = 0;       // into about how many segments the rule divides it
    bool proven = true;    // to keep to the rule
    bool hopeless = false; // it does not, but of its parts nobody can prove that they do

    [[nodiscard]] bool fits() const noexcept { return need <= 1; }
    [[nodiscard]] bool stays() const noexcept { return fits() || hopeless; }
};

// A place between pieces.
struct Corner {
    double t;
    bool jump; // else a kink, or no more than rounding
};

class CurveParts {
public:
    CurveParts(const Spline &curve, const PolylineRule &rule);

    [[nodiscard]] const Spline &curve() const noexcept { return curve_; }
    // Jumps, and breaks at which the direction changes by more than rounding or is not known; without the ends.
    [[nodiscard]] std::vector<Corner> corners() const;
    // Whether the curve ends where it begins, up to rounding.
    [[nodiscard]] bool closed() const;
    [[nodiscard]] Vertex vertex(double t, bool left) const;
    // Between vertices without a jump in between, from.t < to.t. Cost: linear in the number of pieces between.
    [[nodiscard]] Segment segment(const Vertex &from, const Vertex &to);

private:
    struct Sizes { // of a segment
        double bound = 0, floor = 0, turning = 0, extent = 0;
        bool hidden = true; // by rounding, which may have made all weights 0
    };

    // At the start of piece e > 0.
    [[nodiscard]] std::optional<Corner> corner(size_t e) const;
    // Whether limits from the left and from the right are one point, up to rounding.
    [[nodiscard]] bool meet(const Vertex &before, const Vertex &after) const;
    [[nodiscard]] bool smooth(size_t e) const;
    // The piece that holds t, the later or the earlier one of two.
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
