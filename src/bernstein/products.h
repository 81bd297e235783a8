// SPDX-License-Identifier: MIT
// Tensor products of Bernstein polynomials as plain arrays: the pieces on which bounds are proved, because a
// polynomial lies in the convex hull of its coefficients (Farouki & Rajan, "Algorithms for polynomials in
// Bernstein form", CAGD 5 (1988)).
#pragma once

#include "base/limits.h"
#include "bernstein/de_casteljau.h"
#include "numeric/binomial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nrb::inline bernstein {

// Degrees of the last axes of the three, those in front have degree 0; `width` values for each coefficient,
// last axis fastest.
struct BernsteinShape {
    std::array<int, max_axes> degrees{};
    int width = 1;

    [[nodiscard]] int64_t coefficients() const noexcept {
        return int64_t{degrees[0] + 1} * (degrees[1] + 1) * (degrees[2] + 1);
    }
    [[nodiscard]] int64_t values() const noexcept { return coefficients() * width; }
    // The coefficient at a corner: where bit k of its number is 1, the upper end of axis k.
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

// Coefficient j of a polynomial of degree `low` in coefficient i of the same one at degree `high`; within
// 2 eps of itself.
double elevation_coefficient(int low, int high, int i, int j) noexcept;

// The product of polynomials of these shapes, b a scalar one: the degrees add up. Every value is within
// product_error() of itself, relative to the sum of the magnitudes of its terms. Precondition: b.width == 1;
// all degrees of the product are at most max_product_degree.
BernsteinShape product_shape(const BernsteinShape &a, const BernsteinShape &b) noexcept;
double product_error(const BernsteinShape &a, const BernsteinShape &b) noexcept;

// Roundings of binomial_factors(), of eps each: of the rows and of their products.
double binomial_steps(const BernsteinShape &shape) noexcept;

// For each value the binomials that belong to its coefficient: times these, factors are multiplied by
// add_convolution(), and divided by those of its shape the sum is the product.
std::vector<double> binomial_factors(const BernsteinShape &shape);
void fill_binomial_factors(const BernsteinShape &shape, double *out); // [shape.values()]
// out += a * b; out overlaps neither. Cost: a.values() * b.coefficients().
void add_convolution(const BernsteinShape &a, const double *left, const BernsteinShape &b,
                     const double *right, double *out);

// Halves along an axis of the three: `values` becomes the upper one. Precondition: lower does not overlap
// values.
inline void halve(const BernsteinShape &shape, int axis, double *values, double *lower) noexcept {
    subdivide(shape.along(axis), 0.5, values, lower);
}

} // namespace nrb::inline bernstein
