// SPDX-License-Identifier: MIT
// Bernstein polynomials that know how far rounding may have moved their coefficients.
#pragma once

#include "bernstein/products.h"

#include <limits>
#include <vector>

namespace nrb::inline bernstein {

inline constexpr int last_axis = 2; // of the three; the one along which curves lie

// Every value is within error(i) of the exact one, by a running error analysis that follows all operations.
// Nothing is relative to a scale of its own, so nothing depends on that of a model or of its weights.
struct RoundedPolynomial {
    BernsteinShape shape;
    std::vector<double> values;
    std::vector<double> errors;

    // With what the rounding of the bounds themselves may amount to.
    [[nodiscard]] double error(size_t i) const noexcept { return 1.01 * errors[i]; }
    // 1 or -1, 0 where rounding hides it.
    [[nodiscard]] int sign(size_t i) const noexcept {
        const double e = error(i);
        return values[i] > e ? 1 : values[i] < -e ? -1 : 0;
    }
};

// A constant.
RoundedPolynomial constant(double value);
// Component c as a scalar polynomial.
RoundedPolynomial component(const RoundedPolynomial &a, int c);
// Scalar polynomials of one shape side by side.
RoundedPolynomial side_by_side(const std::vector<RoundedPolynomial> &components);

// The degrees add up; b is a scalar one. Cost: four times a.values times b.coefficients.
RoundedPolynomial operator*(const RoundedPolynomial &a, const RoundedPolynomial &b);
// a + factor b, raised to common degrees. Precondition: the widths agree.
RoundedPolynomial sum(const RoundedPolynomial &a, double factor, const RoundedPolynomial &b);
inline RoundedPolynomial operator+(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    return sum(a, 1, b);
}
inline RoundedPolynomial operator-(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    return sum(a, -1, b);
}
RoundedPolynomial scaled(RoundedPolynomial a, double factor);
// The sum of products of components.
RoundedPolynomial dot(const RoundedPolynomial &a, const RoundedPolynomial &b);
// In dimension 2 the third component alone.
RoundedPolynomial cross(const RoundedPolynomial &a, const RoundedPolynomial &b);
// With respect to the place between 0 and 1 on an axis of the three; a constant 0 where the degree is 0.
RoundedPolynomial derivative(const RoundedPolynomial &a, int axis);
// Degree 0 on an axis: its value at the lower or the upper end.
RoundedPolynomial end_value(const RoundedPolynomial &a, int axis, bool upper);

// de Casteljau's subdivision at `place`; `a` becomes the upper part.
RoundedPolynomial split(RoundedPolynomial &a, int axis, double place = 0.5);
// Degree 0 on an axis: its value at `place`.
RoundedPolynomial value_at(RoundedPolynomial a, int axis, double place);

// Divides by x, or by 1 - x if `upper`, as often as the coefficients at that end vanish to rounding; the
// number of times, `most` of them, -1 for a polynomial that vanishes to rounding altogether.
int divide_end(RoundedPolynomial &a, int axis, bool upper, int most = std::numeric_limits<int>::max());

bool vanishes(const RoundedPolynomial &a) noexcept; // to rounding
// 1 or -1: all coefficients have that sign for certain; else 0.
int certain_sign(const RoundedPolynomial &a) noexcept;

} // namespace nrb::inline bernstein
