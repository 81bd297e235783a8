// SPDX-License-Identifier: MIT
// Vectors whose cone contains the directions of the derivatives of a part of a surface (a hodograph up to
// positive factors).
#pragma once

#include "intersect/surfaces/cross_cell.h"

#include <vector>

namespace nrb::intersect {

// A vector, and a bound of its error.
struct TangentRay {
    Vector3 way;
    double off;
};

// Rays of a part of a piece. Let P_i and w_i be its control points and weights along an axis of degree p, and
// C(p, i) binomial coefficients. The derivative along the axis, times the square of the weight function, is
// the sum over i < j of
//     (j - i) C(p, i) C(p, j) t^(i + j - 1) (1 - t)^(2 p - i - j - 1) w_i w_j (P_j - P_i),
// and over all pairs of layers along the other axis, with P_i in the one and P_j in the other. Terms with
// equal powers of t, and equal sums of the indices of both layers, make one ray: derivatives are positive
// combinations of the rays. (The derivative of a curve is in the cone of the chords of its control polygon:
// M. Floater, CAGD 9 (1992).) If all weights are equal, the rays are the legs of the control net.
class Tangents {
public:
    Tangents(const CrossPiece &piece, const std::array<Interval, 2> &places);

    // The rays of the derivative along an axis. without: the side of the other axis, 0 or 1, along which the
    // derivative vanishes; the rays are then those of the derivative divided by the distance from that side.
    void add_rays(size_t axis, std::optional<size_t> without, std::vector<TangentRay> &rays) const;
    // Rays from a point to the control points of the part, except those on side `without` of the axis.
    void add_rays_from(const Vector3 &point, size_t axis, std::optional<size_t> without,
                       std::vector<TangentRay> &rays) const;
    [[nodiscard]] const Vector3 &corner(size_t end_u, size_t end_v) const noexcept {
        return points_[place(0, end_u * static_cast<size_t>(degrees_[0]),
                             end_v * static_cast<size_t>(degrees_[1]))];
    }

private:
    // The index of the control point in layer i along an axis and j along the other one.
    [[nodiscard]] size_t place(size_t axis, size_t i, size_t j) const noexcept {
        const auto row = static_cast<size_t>(degrees_[1]) + 1;
        return axis == 0 ? i * row + j : j * row + i;
    }
    void add_legs(size_t axis, size_t first, size_t last, std::vector<TangentRay> &rays) const;
    [[nodiscard]] TangentRay sum_of_chords(size_t axis, size_t power, size_t layers) const noexcept;

    std::array<int, 2> degrees_;
    std::vector<Vector3> points_;
    std::vector<double> weights_;
    std::array<const double *, 2> binomials_;
    bool rational_ = false;
    double error_; // of control points
};

} // namespace nrb::intersect
