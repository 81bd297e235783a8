// SPDX-License-Identifier: MIT
// Features of a curve: inflections, extrema of curvature, cusps, kinks, jumps and changes of torsion.
#pragma once

#include "spline/spline.h"

#include <cstdint>
#include <vector>

namespace nrb::analysis {

enum FeatureKind : int32_t {
    feature_inflection = 0x01,        // in the plane: the curvature changes its sign; in space: it vanishes
    feature_curvature_maximum = 0x02, // a local maximum of |curvature|
    feature_curvature_minimum = 0x04, // a local minimum of |curvature| other than 0
    feature_cusp = 0x08,              // the first derivative vanishes
    feature_kink = 0x10,              // a knot where the direction of the tangent jumps
    feature_jump = 0x20,              // a knot where the curve jumps
    feature_torsion = 0x40,           // the torsion changes its sign
};

struct Feature {
    double at;
    int32_t kind;
    double value;
};

struct Features {
    std::vector<Feature> list; // in increasing order
    bool complete = true;
};

// With A, w of a piece, D = A' w - A w', S = D . D and M = w^3 C' x C'' (derivative_pieces.h), all
// polynomials:
//   curvature = M w^3 / S^(3/2),
//   (curvature^2)' = M w^5 / S^4 (2 M' w S + 6 M w' S - 3 M w S') in the plane,
//   (curvature^2)' = w^5 / S^4 (Q' w S + 6 Q w' S - 3 Q w S') with Q = M . M in space.
// Inflections in the plane are therefore sign changes of M, and extrema of |curvature| follow from the signs
// of the polynomials in parentheses, of degrees up to 8 p - 6 and 11 p - 9. If the curvature jumps at a knot,
// it counts as increasing or decreasing there. There are no features at the ends of the domain, except cusps,
// and what happens at the seam of a periodic curve. Throws Status::not_representable. Precondition: a curve
// of dimension 2 or 3.
Features curve_features(const Spline &curve, uint32_t kinds);

} // namespace nrb::analysis
