// SPDX-License-Identifier: MIT
#include "build/surfaces/multilinear.h"

#include "base/representable.h"
#include "build/placement.h"
#include "numeric/double_double.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::build {

namespace {

SplinePtr over_corners(int axes, int dim, std::vector<double> corners) {
    const KnotVectorPtr axis = refine::bezier_knots(1, std::array<double, 2>{0, 1});
    return make_spline(Spline::Axes(static_cast<size_t>(axes), axis), dim, Form::polynomial,
                       std::move(corners));
}

// The direction times a power of two that brings its largest component into [1, 2).
std::vector<double> scaled_direction(int dim, const double *x) {
    std::vector<double> scaled(x, x + dim);
    const int exponent = std::ilogb(std::fabs(
        *std::max_element(x, x + dim, [](double a, double b) { return std::fabs(a) < std::fabs(b); })));
    std::ranges::transform(scaled, scaled.begin(), [=](double c) { return std::ldexp(c, -exponent); });
    return scaled;
}

// Whether two vectors are parallel to within rounding. If component k of u is the largest, v - (v_k / u_k) u
// is 0 only for parallel vectors.
bool parallel(int dim, const double *side_u, const double *side_v) {
    const std::vector<double> u = scaled_direction(dim, side_u), v = scaled_direction(dim, side_v);
    const auto largest =
        std::ranges::max_element(u, [](double a, double b) { return std::fabs(a) < std::fabs(b); });
    const auto k = static_cast<size_t>(largest - u.begin());
    double across = 0;
    for (size_t c = 0; c < u.size(); ++c) {
        across = std::max(
            across,
            std::fabs((DoubleDouble::product(u[k], v[c]) - DoubleDouble::product(v[k], u[c])).value()));
    }
    return across <= 4 * 0x1p-52;
}

} // namespace

SplinePtr multilinear(int axes, const ConstRecords &corners) {
    std::vector<double> points;
    for (int64_t i = 0; i < corners.count; ++i) {
        for (int64_t c = 0; c < corners.width; ++c) {
            points.push_back(corners(i, c));
            if (!std::isfinite(points.back())) {
                fail(Status::point_not_finite, "corners[%lld][%lld] = %s is not finite",
                     static_cast<long long>(i), static_cast<long long>(c), Number(points.back()).text);
            }
        }
    }
    return over_corners(axes, static_cast<int>(corners.width), std::move(points));
}

SplinePtr parallelogram(int dim, const double *origin, const double *u, const double *v) {
    if (origin != nullptr) {
        check_point(origin, dim, "origin");
    }
    check_direction(u, dim, "u");
    check_direction(v, dim, "v");
    if (parallel(dim, u, v)) {
        fail(Status::direction, "u and v are parallel, expected two sides of a parallelogram");
    }
    std::vector<double> corners;
    for (const auto &[s, t] : {std::array{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}, {1.0, 1.0}}) {
        for (int c = 0; c < dim; ++c) {
            const DoubleDouble moved = DoubleDouble::sum(s * u[c], t * v[c]);
            corners.push_back((DoubleDouble(origin == nullptr ? 0 : origin[c]) + moved).value());
        }
    }
    require_representable(corners, "corners");
    return over_corners(2, dim, std::move(corners));
}

} // namespace nrb::build
