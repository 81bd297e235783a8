// SPDX-License-Identifier: MIT
#include "refine/forms/projections.h"

#include "base/numbers.h"
#include "refine/forms/transform.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

// A vector scaled by a power of two that brings its largest component near 1, so that products stay in range.
std::vector<double> near_one(const double *x, int dim, const char *name) {
    double largest = 0;
    for (int c = 0; c < dim; ++c) {
        largest = std::max(largest, std::abs(x[c]));
    }
    if (largest == 0) {
        fail(Status::direction, "%s is 0", name);
    }
    std::vector<double> result(x, x + dim);
    const int exponent = std::ilogb(largest);
    std::transform(result.begin(), result.end(), result.begin(),
                   [exponent](double c) { return std::ldexp(c, -exponent); });
    return result;
}

struct Product {
    double value;
    double size; // the sum of the magnitudes of the terms
};

// a . (x - y); a null y stands for 0.
Product product(const std::vector<double> &a, const double *x, const double *y) noexcept {
    Product sum{0, 0};
    for (size_t c = 0; c < a.size(); ++c) {
        const double term = a[c] * (y == nullptr ? x[c] : x[c] - y[c]);
        sum = {sum.value + term, sum.size + std::abs(term)};
    }
    return sum;
}

// Whether a sum cannot be distinguished from 0: it is not larger than the bound of its rounding error.
bool vanishes(const Product &sum, size_t terms) noexcept {
    return !(std::abs(sum.value) > static_cast<double>(terms) * eps * sum.size);
}

// The affine map x -> x - factor d (n . (x - point)) / (n . d), applied to a spline.
SplinePtr shear(const Spline &spline, const double *point, const std::vector<double> &n,
                const std::vector<double> &d, double factor) {
    const size_t dim = n.size();
    const Product along = product(n, d.data(), nullptr);
    if (vanishes(along, dim)) {
        fail(Status::direction, "direction is parallel to the plane: normal . direction is 0 to rounding");
    }
    const double height = product(n, point, nullptr).value;
    std::vector<double> matrix(dim * dim), translation(dim);
    for (size_t i = 0; i < dim; ++i) {
        for (size_t j = 0; j < dim; ++j) {
            matrix[i * dim + j] = (i == j ? 1 : 0) - factor * (d[i] * n[j]) / along.value;
        }
        translation[i] = factor * (d[i] * height) / along.value;
    }
    const auto size = static_cast<int64_t>(dim);
    return transform(spline, {size, size, matrix.data()}, translation.data());
}

} // namespace

SplinePtr mirror(const Spline &spline, const double *point, const double *normal) {
    const std::vector<double> n = near_one(normal, spline.dim(), "normal");
    return shear(spline, point, n, n, 2);
}

SplinePtr project_to_plane(const Spline &spline, const double *point, const double *normal,
                           const double *direction) {
    const std::vector<double> n = near_one(normal, spline.dim(), "normal");
    return shear(spline, point, n, direction == nullptr ? n : near_one(direction, spline.dim(), "direction"),
                 1);
}

// The perspective projection x -> eye + (x - eye) h / (n . (x - eye)) with h = n . (point - eye). The last
// row of its matrix gives the weight n . (x - eye).
SplinePtr project_from(const Spline &spline, const double *eye, const double *point, const double *normal) {
    const std::vector<double> n = near_one(normal, spline.dim(), "normal");
    const size_t dim = n.size(), width = dim + 1;
    const Product height = product(n, point, eye);
    if (vanishes(height, dim)) {
        fail(Status::direction, "eye lies in the plane: normal . (point - eye) is 0 to rounding");
    }
    const double after = product(n, eye, nullptr).value;
    std::vector<double> matrix(width * width);
    for (size_t i = 0; i < dim; ++i) {
        for (size_t j = 0; j < dim; ++j) {
            matrix[i * width + j] = eye[i] * n[j] + (i == j ? height.value : 0);
        }
        matrix[i * width + dim] = -eye[i] * (after + height.value);
    }
    std::copy(n.begin(), n.end(), matrix.begin() + static_cast<std::ptrdiff_t>(dim * width));
    matrix.back() = -after;
    const auto size = static_cast<int64_t>(width);
    return transform_projective(spline, {size, size, matrix.data()});
}

} // namespace nrb::refine
