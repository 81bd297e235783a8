// SPDX-License-Identifier: MIT
// The directions of derivatives of a part of a surface.
#pragma once

#include "intersect/surfaces/cross_cell.h"

#include <vector>

namespace nrb::intersect {

// A vector that is off by no more than a radius.
struct TangentRay {
    Vector3 way;
    double off;
};

// Of a part of a piece. With the control points P and the weights w of the part, the derivative along an axis of degree p is, times the square
// of the weight, the sum over i < j of
//     (j - i) C(p, i) C(p, j) t^(i + j - 1) (1 - t)^(2 p - i - j - 1) w_i w_j (P_j - P_i),
// over all pairs of layers along the other axis: its directions are positive multiples of sums of rays, one for each power. (Those of
// a curve are in the cone of chords of its control polygon: M. Floater, CAGD 9 (1992).) Without weights rays are legs.
class Tangents {
public:
    Tangents(const CrossPiece &piece, const std::array<Interval, 2> &places);

    // Those along an axis; `without`: the side of the other axis, 0 or 1, at which the derivative vanishes: rays are of the derivative
    // divided by the distance from it.
    void add_rays(size_t axis, std::optional<size_t> without, std::vector<TangentRay> &rays) const;
    // From a point to all of the part, but the control points on a side of an axis.
    void add_rays_from(const Vector3 &point, size_t axis, std::optional<size_t> without,
                       std::vector<TangentRay> &rays) const;
    [[nodiscard]] const Vector3 &corner(size_t end_u, size_t end_v) const noexcept {
        return points_[place(0, end_u * static_cast<size_t>(degrees_[0]),
                             end_v * static_cast<size_t>(degrees_[1]))];
    }

private:
    // Layer i along an axis, j along the other one.
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
    double error_; // of points
};

} // namespace nrb::intersect
