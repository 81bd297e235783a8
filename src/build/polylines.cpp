// SPDX-License-Identifier: MIT
#include "build/polylines.h"

#include "base/checked.h"
#include "base/error.h"
#include "base/representable.h"
#include "build/conics/angle.h"
#include "build/conics/arc.h"
#include "build/make_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace nrb::build {

namespace {

void check_params(std::span<const double> params) {
    for (size_t i = 0; i < params.size(); ++i) {
        if (!std::isfinite(params[i])) {
            fail(Status::parameter_not_finite, "params[%zu] = %s is not finite", i, Number(params[i]).text);
        }
        if (i > 0 && !(params[i] > params[i - 1])) {
            fail(Status::knots_decreasing, "params[%zu] = %s, expected more than params[%zu] = %s", i,
                 Number(params[i]).text, i - 1, Number(params[i - 1]).text);
        }
    }
}

void append(std::vector<double> &points, const Placement &place, double x, double y) {
    points.resize(points.size() + static_cast<size_t>(place.dim));
    place.point(x, y, 0, points.data() + points.size() - place.dim);
}

// Appends the first point once more; throws if a coordinate has overflowed.
void close(std::vector<double> &points, int dim) {
    require_representable(points, "the corners");
    for (int c = 0; c < dim; ++c) {
        points.push_back(points[static_cast<size_t>(c)]);
    }
}

SplinePtr rectangle(const Placement &place, double x, double y) {
    std::vector<double> points;
    append(points, place, -x, -y);
    append(points, place, x, -y);
    append(points, place, x, y);
    append(points, place, -x, y);
    close(points, place.dim);
    return polyline(place.dim, std::move(points), even_params(5));
}

// Bezier points and weights of consecutive quadratic pieces; the common end of two pieces is stored once.
class Outline {
public:
    explicit Outline(const Placement &place) : place_(place) {}

    void start(double x, double y) { add(x, y, 1); }
    // A straight side to a point, unless its length is 0.
    void side(double from_x, double from_y, double x, double y) {
        if (from_x != x || from_y != y) {
            add(from_x + (x - from_x) / 2, from_y + (y - from_y) / 2, 1);
            add(x, y, 1);
        }
    }
    void corner(double corner_x, double corner_y, double x, double y) {
        add(corner_x, corner_y, 0.70710678118654752440);
        add(x, y, 1);
    }
    SplinePtr closed() && {
        points_.resize(points_.size() - static_cast<size_t>(place_.dim));
        close(points_, place_.dim);
        KnotVectorPtr axis = piecewise_knots(std::ssize(weights_) / 2);
        return make_shape({std::move(axis)}, place_.dim, std::move(points_), std::move(weights_));
    }

private:
    void add(double x, double y, double weight) {
        append(points_, place_, x, y);
        weights_.push_back(weight);
    }

    const Placement &place_;
    std::vector<double> points_;
    std::vector<double> weights_;
};

} // namespace

std::vector<double> even_params(int64_t n) {
    std::vector<double> params(static_cast<size_t>(n));
    for (int64_t i = 0; i < n; ++i) {
        params[static_cast<size_t>(i)] = static_cast<double>(i) / static_cast<double>(n - 1);
    }
    return params;
}

SplinePtr polyline(int dim, std::vector<double> points, std::vector<double> params) {
    if (params.size() < 2) {
        fail(Status::too_few_points, "n = %zu, expected at least 2 points", params.size());
    }
    check_params(params);
    std::vector<double> knots;
    knots.reserve(params.size() + 2);
    knots.push_back(params.front());
    knots.insert(knots.end(), params.begin(), params.end());
    knots.push_back(params.back());
    return make_spline({make_knot_vector(1, std::move(knots))}, dim, Form::polynomial, std::move(points));
}

SplinePtr regular_polygon(const Placement &place, double radius, int64_t sides) {
    check_positive_length(radius, "radius");
    if (sides < 3) {
        fail(Status::count, "sides = %lld, expected at least 3", static_cast<long long>(sides));
    }
    std::vector<double> points;
    points.reserve(static_cast<size_t>(checked_product(checked_sum(sides, 3, "sides"), place.dim, "points")));
    for (int64_t i = 0; i < sides; ++i) {
        const Direction d = Angle::quarters(4).part(i, sides).direction();
        append(points, place, radius * d.cos, radius * d.sin);
    }
    close(points, place.dim);
    return polyline(place.dim, std::move(points), even_params(sides + 1));
}

SplinePtr rounded_rectangle(const Placement &place, double width, double height, double corner_radius) {
    check_positive_length(width, "width");
    check_positive_length(height, "height");
    const double x = width / 2, y = height / 2, r = corner_radius;
    if (!(r >= 0 && r <= std::min(x, y))) {
        fail(Status::length, "corner_radius = %s, expected 0 to %s, half of the smaller side", Number(r).text,
             Number(std::min(x, y)).text);
    }
    if (r == 0) {
        return rectangle(place, x, y);
    }
    Outline outline(place);
    outline.start(r - x, -y);
    outline.side(r - x, -y, x - r, -y);
    outline.corner(x, -y, x, r - y);
    outline.side(x, r - y, x, y - r);
    outline.corner(x, y, x - r, y);
    outline.side(x - r, y, r - x, y);
    outline.corner(-x, y, -x, y - r);
    outline.side(-x, y - r, -x, r - y);
    outline.corner(-x, -y, r - x, -y);
    return std::move(outline).closed();
}

} // namespace nrb::build
