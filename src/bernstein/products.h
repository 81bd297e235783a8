// SPDX-License-Identifier: MIT
// Products of tensor-product Bernstein polynomials as plain arrays. Bounds are proven on these pieces,
// because a polynomial lies in the convex hull of its coefficients (Farouki & Rajan, "Algorithms for
// polynomials in Bernstein form", CAGD 5 (1988)).
#pragma once

#include "base/limits.h"
#include "bernstein/de_casteljau.h"
#include "numeric/binomial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nrb::inline bernstein {

// The degrees of a polynomial, stored for the last of the three axes; axes in front have degree 0. `width`
// values for each coefficient, last axis fastest.
struct BernsteinShape {
    std::array<int, max_axes> degrees{};
    int width = 1;

    [[nodiscard]] int64_t coefficients() const noexcept {
        return int64_t{degrees[0] + 1} * (degrees[1] + 1) * (degrees[2] + 1);
    }
    [[nodiscard]] int64_t values() const noexcept { return coefficients() * width; }
    // Index of the coefficient at a corner: bit k of `number` is 1 at the upper end of axis k.
    [[nodiscard]] int64_t corner(int number) const noexcept {
        int64_t i = 0;
        for (int k = 0; k < max_axes; ++k) {
            const int degree = degrees[static_cast<size_t>(k)];
            i = i * (degree + 1) + ((number >> k & 1) != 0 ? degree : 0);
        }
        return i;
    }
    [[nodiscard]] AxisLayers along(int axis) const noexcept;
};

// Degree elevation: the factor of coefficient j of a polynomial of degree `low` in coefficient i of the same
// polynomial at degree `high`, with a relative error within 2 eps.
double elevation_coefficient(int low, int high, int i, int j) noexcept;

// The product of polynomials of these shapes, where b is scalar: the degrees add up. Every value is accurate
// to product_error() times the sum of the magnitudes of its terms. Preconditions: b.width == 1; all degrees
// of the product are at most max_product_degree.
BernsteinShape product_shape(const BernsteinShape &a, const BernsteinShape &b) noexcept;
double product_error(const BernsteinShape &a, const BernsteinShape &b) noexcept;

// Rounding errors of binomial_factors(), in units of eps: of the rows and of their products.
double binomial_steps(const BernsteinShape &shape) noexcept;

// For each value the binomial that belongs to its coefficient. Products are formed in scaled Bernstein form:
// factors are multiplied by their binomials, convolved by add_convolution(), and the sum is divided by the
// binomials of the product.
std::vector<double> binomial_factors(const BernsteinShape &shape);
void fill_binomial_factors(const BernsteinShape &shape, double *out); // [shape.values()]
// out += a * b; out overlaps neither. Cost: a.values() * b.coefficients().
void add_convolution(const BernsteinShape &a, const double *left, const BernsteinShape &b,
                     const double *right, double *out);

// Halves along one of the three axes: `values` becomes the upper half. Precondition: lower does not overlap
// values.
inline void halve(const BernsteinShape &shape, int axis, double *values, double *lower) noexcept {
    subdivide(shape.along(axis), 0.5, values, lower);
}

} // namespace nrb::inline bernstein
