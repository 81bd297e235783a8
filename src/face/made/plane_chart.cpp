// SPDX-License-Identifier: MIT
#include "face/made/plane_chart.h"

#include "base/error.h"
#include "base/numbers.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

std::vector<double> control_point(const Spline &edge, int64_t i) {
    std::vector<double> point;
    point.reserve(static_cast<size_t>(edge.dim()));
    for (int c = 0; c < edge.dim(); ++c) {
        point.push_back(edge.coordinate(i, c));
    }
    return point;
}

// A curve with the knots and weights of another one.
SplinePtr with_points(const Spline &curve, int dim, const std::vector<double> &points) {
    std::vector<double> weights;
    for (int64_t i = 0; curve.rational() && i < curve.point_count(); ++i) {
        weights.push_back(curve.weight(i));
    }
    return make_result(curve.knot_vectors(), dim, curve.rational() ? Form::rational : Form::polynomial,
                       points, weights);
}

// Whether two curves have the same (rational) basis functions.
bool same_basis(const Spline &a, const Spline &b) noexcept {
    const std::span<const double> knots = a.axis(0).knots(), others = b.axis(0).knots();
    bool same = a.axis(0).degree() == b.axis(0).degree() &&
                std::equal(knots.begin(), knots.end(), others.begin(), others.end());
    for (int64_t i = 0; i < a.point_count() && same; ++i) {
        same = a.weight(i) == b.weight(i);
    }
    return same;
}

} // namespace

std::optional<PlaneChart> PlaneChart::of(const Spline &surface) {
    const auto weights = surface.all_weights();
    if (!(weights.smallest == weights.largest && weights.smallest > 0) || surface.axis(0).degree() != 1 ||
        surface.axis(1).degree() != 1 || surface.point_count() != 4 || surface.axis(0).periodic() ||
        surface.axis(1).periodic()) {
        return std::nullopt;
    }
    const auto dim = static_cast<size_t>(surface.dim());
    PlaneChart chart;
    const KnotVector &u = surface.axis(0), &v = surface.axis(1);
    chart.origin_ = {u[1], v[1]};
    chart.far_ = {u[2], v[2]};
    double off = 0, largest = 0;
    for (size_t c = 0; c < dim; ++c) {
        const auto p = [&](int64_t i) { return surface.coordinate(i, static_cast<int>(c)); };
        chart.by_u_.push_back((p(2) - p(0)) / (u[2] - u[1]));
        chart.by_v_.push_back((p(1) - p(0)) / (v[2] - v[1]));
        off = std::max(off, std::abs((p(3) - p(2)) - (p(1) - p(0))));
        for (int64_t i = 0; i < 4; ++i) {
            largest = std::max(largest, std::abs(p(i)));
        }
    }
    for (int64_t i = 0; i < 4; ++i) {
        const std::vector<double> corner = control_point(surface, i);
        chart.corners_.insert(chart.corners_.end(), corner.begin(), corner.end());
    }
    // The rows of the pseudoinverse, from the first fundamental form.
    const double uu = dot(chart.by_u_, chart.by_u_), uv = dot(chart.by_u_, chart.by_v_),
                 vv = dot(chart.by_v_, chart.by_v_);
    const double determinant = uu * vv - uv * uv;
    if (off > 8 * eps * largest || !(determinant > 1e-12 * uu * vv)) {
        return std::nullopt;
    }
    for (size_t c = 0; c < dim; ++c) {
        chart.to_u_.push_back((vv * chart.by_u_[c] - uv * chart.by_v_[c]) / determinant);
        chart.to_v_.push_back((uu * chart.by_v_[c] - uv * chart.by_u_[c]) / determinant);
    }
    return chart;
}

Point2 PlaneChart::place(const double *point) const noexcept {
    double u = 0, v = 0;
    for (size_t c = 0; c < by_u_.size(); ++c) {
        u += to_u_[c] * (point[c] - corners_[c]);
        v += to_v_[c] * (point[c] - corners_[c]);
    }
    return {origin_[0] + u, origin_[1] + v};
}

double PlaneChart::distance_of(const double *point, const Point2 &place) const noexcept {
    return norm_of(static_cast<int>(by_u_.size()), [&](int k) {
        const auto c = static_cast<size_t>(k);
        return point[c] - corners_[c] - by_u_[c] * (place[0] - origin_[0]) -
               by_v_[c] * (place[1] - origin_[1]);
    });
}

MadeCurve PlaneChart::curve_under(const Spline &edge, double tolerance) const {
    std::vector<double> points;
    double farthest = 0;
    for (int64_t i = 0; i < edge.point_count(); ++i) {
        const std::vector<double> point = control_point(edge, i);
        const Point2 x = place(point.data());
        farthest = std::max(farthest, distance_of(point.data(), x));
        points.insert(points.end(), x.begin(), x.end());
    }
    if (!(farthest <= tolerance)) {
        fail(Status::gap, "the edge is %s from the plane of the surface, expected at most the tolerance %s",
             Number(farthest).text, Number(tolerance).text);
    }
    return {with_points(edge, 2, points), farthest, true};
}

SplinePtr PlaneChart::edge_over(const Spline &curve) const {
    const size_t dim = by_u_.size();
    std::vector<double> points;
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        Point2 share{};
        for (size_t k = 0; k < 2; ++k) {
            share[k] = (curve.coordinate(i, static_cast<int>(k)) - origin_[k]) / (far_[k] - origin_[k]);
        }
        for (size_t c = 0; c < dim; ++c) {
            const double *p = corners_.data() + c;
            points.push_back(std::lerp(std::lerp(p[0], p[dim], share[1]),
                                       std::lerp(p[2 * dim], p[3 * dim], share[1]), share[0]));
        }
    }
    return with_points(curve, static_cast<int>(dim), points);
}

double PlaneChart::distance_between(const Spline &curve, const Spline &edge) const {
    if (!same_basis(curve, edge)) {
        return infinity;
    }
    double farthest = 0;
    for (int64_t i = 0; i < edge.point_count(); ++i) {
        const Point2 x{curve.coordinate(i, 0), curve.coordinate(i, 1)};
        farthest = std::max(farthest, distance_of(control_point(edge, i).data(), x));
    }
    return farthest;
}

} // namespace nrb::face
