// SPDX-License-Identifier: MIT
// Squared distance minimisation: the squared distance of a point to a spline that moves.
#pragma once

#include "eval/kernels/slots.h"
#include "numeric/solvers/small_systems.h"

#include <vector>

namespace nrb::fit {

// A quadratic model of the squared distance of a point x to the spline. Let s be the foot of x, r = x - s,
// and s_a, s_ab the derivatives at the foot along the axes a, b. If the spline moves by m there, and the foot
// slides along the spline by dt, then |r - m - s_a dt_a|^2 - r.s_ab dt_a dt_b is least where H dt = -m.s_a
// with H_ab = s_a.s_b - r.s_ab (the effect of m on the tangents is neglected). The squared distance then
// becomes
//
//     (r - m)^T W (r - m),    W = 1 - J H^-1 J^T,    J = (s_1, s_2, ..).
//
// In an orthonormal frame of the tangents, H is 1 + K, where K has the curvatures times the distance. A
// negative eigenvalue of K, on the concave side, counts as 0, so that the eigenvalues of W are from 0 to 1.
// They are 1 in normal directions. In tangential directions they are 0 beside a flat piece, as in the tangent
// distance, and tend to 1 far away from a curved piece, as in the distance to the foot (W. Wang, H. Pottmann,
// Y. Liu, "Fitting B-spline curves to point clouds by curvature-based squared distance minimization", ACM TOG
// 25 (2006); here with the term r.s_ab for surfaces and in any dimension, too). The foot does not slide along
// axes on which it stays, nor along those without a tangent.
class SquaredDistance {
public:
    SquaredDistance(int axes, int dim);

    // `derivatives` up to order 2, [slots][dim]; `stays`: the axes on which the foot does not slide; r is the
    // point minus the foot.
    void set(const double *derivatives, const std::array<bool, max_axes> &stays, const double *r) noexcept;
    // matrix(): the lower triangle of W, row by row; force(): W r.
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
