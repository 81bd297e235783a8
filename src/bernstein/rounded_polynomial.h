// SPDX-License-Identifier: MIT
// Bernstein polynomials with a bound of the rounding error of each coefficient (running error analysis).
#pragma once

#include "bernstein/products.h"

#include <limits>
#include <vector>

namespace nrb::inline bernstein {

inline constexpr int last_axis = 2; // of the three axes; curves lie along it

// Every value is within error(i) of the exact one, by a running error analysis through all operations. No
// tolerance is relative to a fixed scale, so results do not depend on the scale of a model or of its weights.
struct RoundedPolynomial {
    BernsteinShape shape;
    std::vector<double> values;
    std::vector<double> errors;

    // The bound, including the rounding of the bounds themselves.
    [[nodiscard]] double error(size_t i) const noexcept { return 1.01 * errors[i]; }
    // The certain sign, 1 or -1; 0 where the error may hide it.
    [[nodiscard]] int sign(size_t i) const noexcept {
        const double e = error(i);
        return values[i] > e ? 1 : values[i] < -e ? -1 : 0;
    }
};

// A constant.
RoundedPolynomial constant(double value);
// Component c as a scalar polynomial.
RoundedPolynomial component(const RoundedPolynomial &a, int c);
// Combines scalar polynomials of one shape into the components of a vector polynomial.
RoundedPolynomial side_by_side(const std::vector<RoundedPolynomial> &components);

// The product; the degrees add up; b is scalar. Cost: four times a.values times b.coefficients.
RoundedPolynomial operator*(const RoundedPolynomial &a, const RoundedPolynomial &b);
// a + factor b, elevated to common degrees. Precondition: the widths agree.
RoundedPolynomial sum(const RoundedPolynomial &a, double factor, const RoundedPolynomial &b);
inline RoundedPolynomial operator+(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    return sum(a, 1, b);
}
inline RoundedPolynomial operator-(const RoundedPolynomial &a, const RoundedPolynomial &b) {
    return sum(a, -1, b);
}
RoundedPolynomial scaled(RoundedPolynomial a, double factor);
// The dot product of two vector polynomials.
RoundedPolynomial dot(const RoundedPolynomial &a, const RoundedPolynomial &b);
// The cross product; in dimension 2 only its third component.
RoundedPolynomial cross(const RoundedPolynomial &a, const RoundedPolynomial &b);
// With respect to the local parameter in [0, 1] along one of the three axes; constant 0 where the degree is
// 0.
RoundedPolynomial derivative(const RoundedPolynomial &a, int axis);
// Restriction to the lower or the upper end of an axis, which then has degree 0.
RoundedPolynomial end_value(const RoundedPolynomial &a, int axis, bool upper);

// De Casteljau's subdivision at `place`: returns the lower part; `a` becomes the upper part.
RoundedPolynomial split(RoundedPolynomial &a, int axis, double place = 0.5);
// Restriction to `place` on an axis, which then has degree 0.
RoundedPolynomial value_at(RoundedPolynomial a, int axis, double place);

// Divides by x, or by 1 - x if `upper`, as often as the coefficients at that end vanish up to rounding, but
// at most `most` times. Returns the number of divisions, or -1 for a polynomial that vanishes altogether up
// to rounding.
int divide_end(RoundedPolynomial &a, int axis, bool upper, int most = std::numeric_limits<int>::max());

bool vanishes(const RoundedPolynomial &a) noexcept; // up to rounding
// 1 or -1 if all coefficients certainly have that sign; else 0.
int certain_sign(const RoundedPolynomial &a) noexcept;

} // namespace nrb::inline bernstein
