// Coons surfaces as nurbs.h defines them, without rounding: the matrix form S = -[-1 f(u)] M [-1 g(v)]^T with
// the boundary information matrix M.
#pragma once

#include "reference/number.h"
#include "support/spline_data.h"

#include <functional>
#include <vector>

namespace reference {

using Point = std::vector<Rational>;

// Value, or derivative of order 1, of a curve or surface.
Point exact_value(const support::SplineData &data, const std::vector<double> &param);
Point exact_slope(const support::SplineData &curve, double t);

// With two blending functions the linear ones, with four Hermite's F0, F1, G0, G1, the last two times the
// length.
std::vector<Rational> blending_functions(size_t size, const Rational &lower, const Rational &upper,
                                         const Rational &t);

// Curves over the domains of the surface: boundaries, then for a Hermite blend the derivatives across them.
class BoundaryBlend {
public:
    // Corner values are the means of both curves, and so are twists until they are replaced.
    explicit BoundaryBlend(std::vector<support::SplineData> curves);

    [[nodiscard]] size_t order() const { return curves_.size() / 2; }
    // Values (0, 1) and derivatives (2, 3) at the ends of axis 0 and axis 1.
    [[nodiscard]] Point &corner(size_t i, size_t j) { return corners_[i * order() + j]; }
    [[nodiscard]] const Point &corner(size_t i, size_t j) const { return corners_[i * order() + j]; }
    // The same as the curve along axis 1, or along axis 0, has it.
    [[nodiscard]] Point own(size_t i, size_t j, bool along1) const;

    // S(u, v). The entries of M that are functions are the given curves, corrected by the blending functions
    // where they differ from the corners.
    [[nodiscard]] Point value(double u, double v) const;

private:
    [[nodiscard]] const support::SplineData &curve(size_t functional, bool along1) const;
    [[nodiscard]] Point entry(size_t i, double t, bool along1) const;

    std::vector<support::SplineData> curves_;
    std::vector<Point> corners_;
};

} // namespace reference
