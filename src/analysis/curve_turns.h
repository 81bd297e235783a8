// SPDX-License-Identifier: MIT
// Tangents and curvatures of a curve on both sides of a knot, and the angle between them.
#pragma once

#include "pieces/derivative_pieces.h"

#include <optional>
#include <vector>

namespace nrb::analysis {

// The tangent at an end of a piece, in Cartesian units, with a bound on its rounding error.
struct EndTangent {
    std::vector<double> direction; // unit vector; empty if there is none
    double turned = 0;             // largest angle by which rounding may have turned it
};
EndTangent end_tangent(const pieces::HomogeneousPiece &piece, bool upper);

// The angle from one tangent to another, in the plane positive to the left; 0 if it may be due to rounding,
// or if a tangent does not exist.
double turning_angle(const EndTangent &before, const EndTangent &after);

struct EndCurvature {
    double value = 0; // magnitude of the curvature
    double error = 0;
};
// Empty unless C' certainly does not vanish at that end.
std::optional<EndCurvature> end_curvature(const pieces::HomogeneousPiece &piece, bool upper);

} // namespace nrb::analysis
