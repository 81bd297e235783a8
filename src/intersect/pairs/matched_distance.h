// SPDX-License-Identifier: MIT
// An upper bound on the distance of parts of two curve pieces, by matching their points.
#pragma once

#include "intersect/pairs/beside.h"

namespace nrb::intersect {

// The parts of A and B lie between matched places, and r on A is matched with u(r) = f r / (1 - r + f r) on
// B. The factor f is such that a third pair of places agrees as well. In the Bernstein basis this projective
// reparametrization multiplies the coefficients of B by powers of f. So two parts of one rational curve in
// different parametrizations have distance 0, and others a distance of third order in their length. The
// distance is the largest quotient of the Bernstein coefficients of A v - B w and v w, where A and B are
// weighted points with the weights w and v.
class MatchedDistance {
public:
    // Precondition: both pieces are positive().
    void set(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const Beside::Match &match);

    // Rounding and moved() of both pieces are included.
    [[nodiscard]] double upper() const noexcept { return largest_ + rounding_; }
    // In the plane: whether the matched parts, and what continues beyond their ends, are farther apart than
    // `near`. The parts are graphs over x . d. If a matched difference is e along d and h across it, the
    // graphs are h - m e apart there, with a slope m of b.
    [[nodiscard]] bool separates(const Beside &beside, double near) const noexcept;

private:
    // Control points, and weights times binomials.
    struct Part {
        std::vector<double> points, weights;
    };
    void set_part(const pieces::BezierPiece &piece, Interval places, Part &part);

    Part a_, b_;
    std::vector<double> component_;
    std::vector<double> offsets_; // Bernstein coefficients of the difference
    int dim_ = 0;
    double largest_ = 0, rounding_ = 0;
};

} // namespace nrb::intersect
