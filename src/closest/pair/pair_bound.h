// SPDX-License-Identifier: MIT
// Lower bounds of the distance of two Bezier pieces.
#pragma once

#include "closest/pair/pair_descent.h"

namespace nrb::closest {

// Of boxes, [2][dim] each.
double box_distance(const double *a, const double *b, int dim) noexcept;

// Surfaces that separate two pieces: planes and spheres, and in more dimensions the cylinders that project to
// spheres along a direction. With a point p of a and q of b, and n from p to q,
// - no point of the hulls is nearer than their extents along n are apart;
// - if a lies within R of a point c and b at least r away from it, they are r - R apart; c is on the line
// through p and q so that to the samples of both it fits the second order. R and r are the extreme quotients
// of the Bernstein coefficients of |A - c w|^2 and w^2, which for arcs about c are all equal. So parallel
// lines and planes, concentric arcs and spheres, and coaxial cylinders take no halving.
class PairBound {
public:
    // Not above the distance of any two points, moved() of both included; `at` a local minimum. `enough`: no
    // more is wanted. Precondition: both are positive().
    double lower(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const PairPlace &at,
                 double enough);

private:
    struct Extremes {
        double least, most;
    };
    double plane(const pieces::BezierPiece &a, const pieces::BezierPiece &b) const noexcept;
    double spheres(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const PairPlace &at,
                   double enough);
    double sphere(const pieces::BezierPiece &inside, const pieces::BezierPiece &outside, const double *foot,
                  double sign, double radius);
    void sample(const pieces::BezierPiece &piece, std::vector<double> &out);
    Extremes distances(const pieces::BezierPiece &piece, const double *centre);
    void project(double *v) const noexcept;
    void leg_direction(const pieces::BezierPiece &piece, int axis);

    PieceJet jet_;
    std::vector<double> normal_, direction_, centre_, samples_a_, samples_b_;
    std::vector<double> factors_, coordinate_, squares_, weights_, difference_;
    bool projected_ = false;
};

} // namespace nrb::closest
