// SPDX-License-Identifier: MIT
// The squared distance of a point to a spline that moves.
#pragma once

#include "eval/kernels/slots.h"
#include "numeric/solvers/small_systems.h"

#include <vector>

namespace nrb::fit {

// A quadratic model of the squared distance. For a point at r from its foot s, where the spline moves by m: if the foot
// slides along by dt, |r - m - s_a dt_a|^2 - r.s_ab dt_a dt_b is least at H dt = -m.s_a with H = s_a.s_b - r.s_ab (what m
// does to the tangents left out), so that the distance becomes
//
//     (r - m)^T W (r - m),    W = 1 - J H^-1 J^T,    J = (s_1, s_2, ..).
//
// In an orthonormal frame of the tangents H is 1 + K, where K has the curvatures times the distance; where an eigenvalue of
// K is negative, on the hollow side, it counts as 0, so that W has eigenvalues from 0 to 1: in normal directions 1, in
// tangential ones those of the tangent distance, 0, beside a flat piece, and of the distance to the foot, 1, far away from a
// bent one (W. Wang, H. Pottmann, Y. Liu, "Fitting B-spline curves to point clouds by curvature-based squared distance
// minimization", ACM TOG 25 (2006); the term r.s_ab also for surfaces, and in any dimension). Along axes on which the foot
// stays, and that have no tangent, it does not slide.
class SquaredDistance {
public:
    SquaredDistance(int axes, int dim);

    // Derivatives up to order 2 [slots][dim]; `stays` by axes; r = point - foot.
    void set(const double *derivatives, const std::array<bool, max_axes> &stays, const double *r) noexcept;
    // The lower half of W, row after row; W r.
    [[nodiscard]] const std::vector<double> &matrix() const noexcept { return matrix_; }
    [[nodiscard]] const std::vector<double> &force() const noexcept { return force_; }

private:
    [[nodiscard]] const double *tangent(size_t axis) const noexcept;
    [[nodiscard]] double curvature(size_t a, size_t b, const double *r) const noexcept;
    bool add_tangent(size_t axis) noexcept;
    [[nodiscard]] AxisMatrix bends(const double *r) const noexcept;
    void combine(const AxisMatrix &slide, const double *r) noexcept;

    int axes_, dim_;
    const double *derivatives_ = nullptr;
    std::vector<double> frame_; // orthonormal tangents, [found_][dim]
    size_t found_ = 0;
    std::array<size_t, max_axes> axis_of_{};
    AxisMatrix factor_{}; // tangent i = sum_j factor[i][j] frame j
    std::vector<double> matrix_, force_;
};

} // namespace nrb::fit
