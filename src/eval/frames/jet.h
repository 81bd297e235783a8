// SPDX-License-Identifier: MIT
// Jets: Taylor coefficients at one parameter with bounds of their rounding errors. The bounds decide, without
// any tolerance, whether a computed vector may be zero; the coefficients give the limits if it is.
#pragma once

#include "eval/kernels/slots.h"
#include "eval/parameters.h"
#include "numeric/vector3.h"

#include <array>

namespace nrb::eval {

inline constexpr int max_jet_order = 8;

// The coefficients of s^i t^j, where s and t run from the parameter into the domain (side = 1 or -1 along
// each axis). The unit of s and t is about one knot span, so that nothing depends on the scale of the knots,
// but is kept within 2^-64 and 2^64: longer and shorter spans are brought to this range before (magnitude.h).
// The point, i = j = 0, is that of the shape at_origin(). A curve has j = 0 only. In dimension 2, z = 0.
class Jet {
public:
    // Builds the tables that evaluate() reads; may throw std::bad_alloc.
    static void prepare(const Spline &spline);
    // Computes all coefficients of total order up to `order`. Returns false if the parameter gives NaN.
    // Preconditions: prepare() has been called; 1 or 2 axes; dimension 2 or 3; order <= max_jet_order.
    bool evaluate(const Spline &given, const AxisRules &rules, const double *param, int order) noexcept;

    [[nodiscard]] double side(int axis) const noexcept { return side_[static_cast<size_t>(axis)]; }
    // The length of the unit of s or t, measured in the parameter.
    [[nodiscard]] double unit(int axis) const noexcept { return unit_[static_cast<size_t>(axis)]; }
    [[nodiscard]] const Vector3 &at(int i, int j = 0) const noexcept { return values_[place(i, j)]; }
    // A bound of the length of the error of at(i, j).
    [[nodiscard]] double error(int i, int j = 0) const noexcept { return errors_[place(i, j)]; }

private:
    static constexpr size_t slots = (max_jet_order + 1) * (max_jet_order + 2) / 2;
    static size_t place(int i, int j) noexcept { return static_cast<size_t>(slot(2, i, j)); }

    std::array<double, 2> side_{1, 1};
    std::array<double, 2> unit_{1, 1};
    std::array<Vector3, slots> values_;
    std::array<double, slots> errors_;
};

// c(p) of the accuracy contract in nurbs.h.
double accuracy_factor(int degree) noexcept;

} // namespace nrb::eval
