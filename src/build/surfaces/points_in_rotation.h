// SPDX-License-Identifier: MIT
// Many points rotated about an axis together.
#pragma once

#include "numeric/double_double.h"
#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::build {

// An axis of revolution: a point on it, and its direction as a unit vector.
struct AxisLine {
    std::array<double, 3> origin;
    std::array<DoubleDouble, 3> along;
};

// Computes foot + x d + y e for many coordinates, each rounded once; foot, d and e are kept in double-double
// precision. On processors without fused multiply-add, coordinates above 2^990 become NaN.
class PointsInRotation {
public:
    explicit PointsInRotation(int64_t coordinates);
    // The coordinates of the stored points of a spline of dimension 3. With Z the unit vector of the axis,
    // the foot is the point of the axis nearest to the control point, d is the vector from the foot to the
    // control point, and e = Z x d. In homogeneous records all three are multiplied by the weight, and the
    // weight itself does not change.
    PointsInRotation(const Spline &spline, const AxisLine &axis);

    void set(int64_t coordinate, const DoubleDouble &foot, const DoubleDouble &d,
             const DoubleDouble &e) noexcept;
    // The values of all coordinates, in their order.
    void values(double x, double y, double *out) const noexcept;

private:
    static constexpr int parts = 6; // foot, d and e, each with its remainder
    [[nodiscard]] std::array<double *, parts> arrays() noexcept;

    int64_t size_;
    int64_t stride_; // between the parts; a multiple of the vector length
    std::vector<double> data_;
};

} // namespace nrb::build
