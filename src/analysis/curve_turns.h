// SPDX-License-Identifier: MIT
// What happens at the knots of a curve.
#pragma once

#include "pieces/derivative_pieces.h"

#include <optional>
#include <vector>

namespace nrb::analysis {

// A tangent or curvature at an end of a piece, in Cartesian units, with a bound of its rounding.
struct EndTangent {
    std::vector<double> direction; // a unit vector; empty where it has none
    double turned = 0;             // at most, by rounding
};
EndTangent end_tangent(const pieces::HomogeneousPiece &piece, bool upper);

// The angle from one tangent to another, in the plane positive to the left; 0 if rounding may have caused it,
// or if there is none.
double turning_angle(const EndTangent &before, const EndTangent &after);

struct EndCurvature {
    double value = 0; // |curvature|
    double error = 0;
};
// Whether C' certainly does not vanish.
std::optional<EndCurvature> end_curvature(const pieces::HomogeneousPiece &piece, bool upper);

// The pieces on both sides of the knots of a curve, including its seam if it is periodic; pieces are kept,
// since two knots need each of them.
class CurvePieces {
public:
    explicit CurvePieces(const Spline &curve);

    [[nodiscard]] const Spline &curve() const noexcept { return curve_; }
    [[nodiscard]] const pieces::PieceMaker &maker() const noexcept { return maker_; }
    [[nodiscard]] const std::vector<pieces::HomogeneousPiece> &pieces() const noexcept { return pieces_; }
    [[nodiscard]] bool periodic() const noexcept { return curve_.axis(0).periodic(); }
    // The piece before piece e, or null.
    [[nodiscard]] const pieces::HomogeneousPiece *before(size_t e) const noexcept;
    // The order of continuity that the knot at the start of piece e guarantees.
    [[nodiscard]] int order(size_t e) const noexcept;
    // The distance of the two limits at the start of piece e; 0 if rounding may have caused it.
    [[nodiscard]] double jump(size_t e) const;

private:
    const Spline &curve_;
    pieces::PieceMaker maker_;
    std::vector<pieces::HomogeneousPiece> pieces_;
};

} // namespace nrb::analysis
