// SPDX-License-Identifier: MIT
// How far parts of two pieces of curves are apart, at most, if their points are matched.
#pragma once

#include "intersect/pairs/beside.h"

namespace nrb::intersect {

// Of parts of A and B between matched places, with B over u(r) = f r / (1 - r + f r), by which a third pair of places
// agrees as well: in the Bernstein basis its coefficients are multiplied by powers of f. So parts of one rational
// curve under two parametrizations have distance 0, and others one of third order. The distance is the largest
// quotient of the coefficients of A v - B w and v w.
class MatchedDistance {
public:
    // Precondition: both are positive().
    void set(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const Beside::Match &match);

    // Rounding and moved() of both are included.
    [[nodiscard]] double upper() const noexcept { return largest_ + rounding_; }
    // In the plane: whether the matched parts, and what goes on beyond their ends, are farther apart than `near`.
    // Over x . d the parts are graphs; with (e, h) the matched difference along d and across it, they are h - m e
    // apart, where m is a slope of b.
    [[nodiscard]] bool separates(const Beside &beside, double near) const noexcept;

private:
    // Points and weights times binomials.
    struct Part {
        std::vector<double> points, weights;
    };
    void set_part(const pieces::BezierPiece &piece, Interval places, Part &part);

    Part a_, b_;
    std::vector<double> component_;
    std::vector<double> offsets_; // coefficients of the difference
    int dim_ = 0;
    double largest_ = 0, rounding_ = 0;
};

} // namespace nrb::intersect
