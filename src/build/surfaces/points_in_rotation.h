// SPDX-License-Identifier: MIT
// Points that rotate about an axis.
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

// For many coordinates the values foot + x d + y e, each rounded once; foot, d and e are kept in twice the
// precision. Without fused multiplication in the processor, coordinates above 2^990 become NaN.
class PointsInRotation {
public:
    explicit PointsInRotation(int64_t coordinates);
    // The coordinates of the stored points of a spline of dimension 3. The foot is the nearest point on the
    // axis Z, d is the vector from the foot to the point, and e = Z x d. Weights of homogeneous records stay,
    // and their feet are multiplied by them.
    PointsInRotation(const Spline &spline, const AxisLine &axis);

    void set(int64_t coordinate, const DoubleDouble &foot, const DoubleDouble &d,
             const DoubleDouble &e) noexcept;
    // All coordinates, in their order.
    void values(double x, double y, double *out) const noexcept;

private:
    static constexpr int parts = 6; // foot, d and e, each with its remainder
    [[nodiscard]] std::array<double *, parts> arrays() noexcept;

    int64_t size_;
    int64_t stride_; // between the parts: whole vectors
    std::vector<double> data_;
};

} // namespace nrb::build
