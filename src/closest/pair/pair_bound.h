// SPDX-License-Identifier: MIT
// Lower bounds on the distance between two Bezier pieces, by separating surfaces.
#pragma once

#include "closest/pair/pair_descent.h"

namespace nrb::closest {

// The distance between two boxes, [2][dim] each; not above the exact value.
double box_distance(const double *a, const double *b, int dim) noexcept;

// The separating surfaces are planes and spheres and, in more than two dimensions, cylinders, whose
// projections along a direction are spheres. Let p on a and q on b be the points of a local minimum of the
// distance, and n the unit vector from p to q.
// - Planes: no two points of the convex hulls are nearer than the gap between the extents of the hulls along
// n.
// - Spheres: if a lies within distance R of a point c, and b at distance r or more from c, then a and b are
// at least r - R apart. The centre c is chosen on the line through p and q such that samples of both pieces
// agree with it to the second order. R and r follow from the largest and smallest quotients of the Bernstein
// coefficients of |A - c w|^2 and w^2, which are all equal if the piece is an arc about c.
// Parallel lines and planes, concentric arcs and spheres, and coaxial cylinders therefore need no halving.
class PairBound {
public:
    // A lower bound on the distance between any two points of the pieces, with moved() of both included.
    // `at`: a local minimum. `enough`: a bound this large need not be improved. Precondition: both pieces are
    // positive().
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
