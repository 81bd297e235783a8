// SPDX-License-Identifier: MIT
// Surfaces and loops for tests of faces.
#pragma once

#include "build/polylines.h"
#include "build/surfaces/quadrics.h"
#include "face/face.h"
#include "refine/forms/parametrization.h"

#include <cmath>
#include <vector>

namespace face_shapes {

using namespace nrb;
using face::Loop;
using face::Point2;

inline SplinePtr plane(double size = 1) {
    const KnotVectorPtr axis = make_knot_vector(1, {0, 0, 1, 1});
    return make_spline({axis, axis}, 3, Form::polynomial, {0, 0, 0, 0, size, 0, size, 0, 0, size, size, 0});
}

inline SplinePtr polygon(const std::vector<Point2> &corners) {
    std::vector<double> points, params;
    for (size_t i = 0; i <= corners.size(); ++i) {
        const Point2 &corner = corners[i % corners.size()];
        points.insert(points.end(), corner.begin(), corner.end());
        params.push_back(static_cast<double>(i));
    }
    return build::polyline(2, points, params);
}

inline SplinePtr line(const Point2 &a, const Point2 &b) {
    return build::polyline(2, {a[0], a[1], b[0], b[1]}, {0, 1});
}

// A circle of four rational arcs, counterclockwise.
inline SplinePtr circle(const Point2 &centre, double radius) {
    const double w = std::sqrt(0.5);
    std::vector<double> points;
    const double corners[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                  {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (const auto &corner : corners) {
        points.push_back(centre[0] + radius * corner[0]);
        points.push_back(centre[1] + radius * corner[1]);
    }
    return make_spline({make_knot_vector(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4})}, 2, Form::rational, points,
                       {1, w, 1, w, 1, w, 1, w, 1});
}

inline Loop loop_of(std::vector<SplinePtr> curves) {
    Loop loop;
    for (SplinePtr &curve : curves) {
        loop.push_back({std::move(curve), nullptr, 0, false});
    }
    return loop;
}

inline build::Placement frame() {
    return build::make_placement(3, nullptr, nullptr, nullptr, "origin");
}

inline SplinePtr cylinder() {
    return build::cylinder(frame(), 1, 2, build::full_turn(), 0);
}
inline SplinePtr torus() {
    return build::torus(frame(), 3, 1, build::full_turn(), build::full_turn(), 0);
}
inline SplinePtr sphere() {
    return build::sphere(frame(), 1, 0);
}

inline SplinePtr segment(const Spline &surface, Point2 a, Point2 b) {
    for (size_t k = 0; k < 2; ++k) {
        const Interval range = surface.axis(static_cast<int>(k)).domain();
        a[k] = range.lower + a[k] * (range.upper - range.lower);
        b[k] = range.lower + b[k] * (range.upper - range.lower);
    }
    return line(a, b);
}

} // namespace face_shapes
