// SPDX-License-Identifier: MIT
#include "recognize/shape_factor.h"

#include "base/numbers.h"
#include "numeric/exact_products.h"
#include "numeric/norm.h"
#include "refine/knots/bezier_rows.h"
#include "spline/kind.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::recognize {

namespace {

void check_segment(const Spline &curve) {
    check_kind(curve, 1);
    if (curve.axis(0).degree() != 2) {
        fail(Status::degree, "g has degree %d, expected 2", curve.axis(0).degree());
    }
    if (curve.count(0) != 3) {
        fail(Status::count, "g has %lld control points, expected 3: one conic segment",
             static_cast<long long>(curve.count(0)));
    }
}

// The three Bezier points and their weights; points are multiplied by their weights if `homogeneous`.
struct Segment {
    bool homogeneous;
    int dim;
    std::vector<double> points;
    std::array<double, 3> weights;

    [[nodiscard]] const double *point(int i) const noexcept { return points.data() + int64_t{i} * dim; }
};

Segment stored_segment(const Spline &curve) {
    Segment segment{curve.form() == Form::homogeneous, curve.dim(), {}, {}};
    for (int i = 0; i < 3; ++i) {
        const double *point = curve.points().data() + int64_t{i} * curve.stored_width();
        segment.points.insert(segment.points.end(), point, point + curve.dim());
        segment.weights[static_cast<size_t>(i)] = curve.weight(i);
    }
    return segment;
}

Segment bezier_segment(const Spline &curve) {
    const KnotVector &axis = curve.axis(0);
    if (axis[0] == axis[2] && axis[3] == axis[5]) {
        return stored_segment(curve);
    }
    const auto net = std::make_shared<const Spline>(
        curve.knot_vectors(), curve.width(), Form::polynomial,
        std::vector<double>(curve.records().begin(), curve.records().begin() + int64_t{3} * curve.width()),
        std::vector<double>());
    const std::vector<double> points = apply_along(*net, 0, refine::bezier_rows(axis)).points;
    Segment segment{curve.rational(), curve.dim(), {}, {1, 1, 1}};
    for (size_t i = 0; i < 3; ++i) {
        const double *record = points.data() + i * static_cast<size_t>(curve.width());
        segment.points.insert(segment.points.end(), record, record + curve.dim());
        segment.weights[i] = curve.rational() ? record[curve.dim()] : 1;
    }
    return segment;
}

// Whether b lies on the line through a and c to within 4 eps of the largest coordinate. Its distance from the
// line is the length of the leg from a to b projected orthogonally to the line; a second projection removes
// the effect of cancellation.
bool on_line(const double *a, const double *b, const double *c, int dim) {
    const auto n = static_cast<size_t>(dim);
    double size = 0;
    std::vector<double> side(n), leg(n);
    for (size_t k = 0; k < n; ++k) {
        size = std::max({size, std::abs(a[k]), std::abs(b[k]), std::abs(c[k])});
        side[k] = c[k] - a[k];
        leg[k] = b[k] - a[k];
    }
    const double length = norm(side.data(), dim);
    for (int pass = 0; pass < 2 && length > 0; ++pass) {
        double along = 0;
        for (size_t k = 0; k < n; ++k) {
            along += leg[k] / length * (side[k] / length);
        }
        for (size_t k = 0; k < n; ++k) {
            leg[k] -= along * side[k];
        }
    }
    return norm(leg.data(), dim) <= 4 * eps * size;
}

// The line is taken through the ends of the longest side of the triangle.
bool collinear(const Segment &segment) {
    const double *p[3] = {segment.point(0), segment.point(1), segment.point(2)};
    const int dim = segment.dim;
    const double lengths[3] = {distance(p[1], p[2], dim), distance(p[2], p[0], dim),
                               distance(p[0], p[1], dim)};
    const auto apex = static_cast<int>(std::max_element(lengths, lengths + 3) - lengths);
    return on_line(p[(apex + 1) % 3], p[apex], p[(apex + 2) % 3], dim);
}

// Computes Cartesian points. A point at infinity is replaced by a point in its direction from the first one.
void divide(Segment &segment) {
    for (size_t i = 0; i < 3; ++i) {
        const double w = segment.weights[i];
        double *point = segment.points.data() + i * static_cast<size_t>(segment.dim);
        for (int c = 0; c < segment.dim && w != 0; ++c) {
            point[c] /= w;
        }
        for (int c = 0; c < segment.dim && w == 0; ++c) {
            point[c] = segment.point(0)[c] + point[c] / segment.weights[0];
        }
    }
}

int32_t kind_of(const Segment &segment, bool at_infinity) {
    const auto [first, middle, last] = segment.weights;
    if (collinear(segment)) {
        return conic_line;
    }
    if (middle == 0 && !at_infinity) {
        return conic_chord;
    }
    const int sign = compare_products(middle, middle, first, last);
    return sign < 0 ? conic_ellipse : sign == 0 ? conic_parabola : conic_hyperbola;
}

} // namespace

ShapeFactor shape_factor(const Spline &curve) {
    check_segment(curve);
    Segment segment = bezier_segment(curve);
    const auto [first, middle, last] = segment.weights;
    if (!(first > 0) || !(last > 0)) {
        fail(Status::weight_sign, "the weights at the ends are %s and %s, expected > 0", Number(first).text,
             Number(last).text);
    }
    const double *record = segment.point(1);
    const bool at_infinity = segment.homogeneous && middle == 0 &&
                             std::any_of(record, record + segment.dim, [](double x) { return x != 0; });
    if (segment.homogeneous) {
        divide(segment);
    }
    return {middle / first * (middle / last), kind_of(segment, at_infinity)};
}

} // namespace nrb::recognize
