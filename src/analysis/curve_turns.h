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

} // namespace nrb::analysis
