// SPDX-License-Identifier: MIT
#include "build/conics/conic_arc.h"

#include "base/error.h"
#include "build/conics/arc.h"
#include "build/make_shape.h"
#include "build/polylines.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace nrb::build {

namespace {

// Control points and weights of consecutive pieces of one degree; the common end of two pieces is stored
// once.
struct Net {
    std::vector<double> points;
    std::vector<double> weights;

    void add(const std::vector<double> &point, double weight) {
        points.insert(points.end(), point.begin(), point.end());
        weights.push_back(weight);
    }
};

std::vector<double> joined(int dim, std::initializer_list<const double *> points) {
    std::vector<double> all;
    for (const double *p : points) {
        all.insert(all.end(), p, p + dim);
    }
    return all;
}

void add_triangle_middle(Net &net, const ConicArc &conic) {
    std::vector<double> point(conic.start);
    for (size_t c = 0; c < point.size(); ++c) {
        point[c] += conic.middle[c] / conic.weight;
    }
    net.add(point, conic.weight);
}

// Adds the inner control points of an elliptic arc: A + (x - 1) U + y V for the inner control points (x, y)
// of the arc of the unit circle. Returns the knots of the arc.
KnotVectorPtr append_ellipse(Net &net, const ConicArc &conic, int32_t form) {
    const double angle = 4 * std::atan2(std::sqrt(conic.below), std::sqrt(conic.above));
    const Arc picture = unit_arc({Angle::from_radians(0), Angle::from_radians(angle)}, form);
    if (picture.points.size() == 3) {
        add_triangle_middle(net, conic);
        return picture.axis;
    }
    for (size_t i = 1; i + 1 < picture.points.size(); ++i) {
        std::vector<double> point(conic.start);
        for (size_t c = 0; c < point.size(); ++c) {
            point[c] += (picture.points[i].x - 1) * conic.u[c] + picture.points[i].y * conic.v[c];
        }
        net.add(point, picture.points[i].weight);
    }
    return picture.axis;
}

// Adds the inner control points of a hyperbolic or parabolic arc; returns its knots. With w = cosh d, the
// homogeneous point a^2 (A, 1) + 2 a b (h, w) + b^2 (B, 1) has the weight 1 for a = sinh(d - u / 2) / sinh d
// and b = sinh(u / 2) / sinh d. The polar values of two such pairs (a, b) are the control points between
// them. All coefficients are positive, so nothing cancels, however sharp the hyperbola is.
KnotVectorPtr append_hyperbola(Net &net, const ConicArc &conic) {
    const double d = 2 * std::asinh(std::sqrt(-conic.below / 2)), whole = std::sinh(d);
    const auto pieces = std::max<int64_t>(1, static_cast<int64_t>(std::ceil(d)));
    if (pieces == 1) {
        add_triangle_middle(net, conic);
        return piecewise_knots(1);
    }
    const double step = d / static_cast<double>(pieces), weight = std::cosh(step);
    const auto add = [&](double a0, double b0, double a1, double b1, double w) {
        std::vector<double> point(conic.start);
        for (size_t c = 0; c < point.size(); ++c) {
            point[c] +=
                ((a0 * b1 + a1 * b0) * conic.middle[c] + b0 * b1 * (conic.end[c] - conic.start[c])) / w;
        }
        net.add(point, w);
    };
    for (int64_t i = 0; i < pieces; ++i) {
        const double at = step * static_cast<double>(i), next = step * static_cast<double>(i + 1);
        const double a0 = std::sinh(d - at) / whole, b0 = std::sinh(at) / whole;
        const double a1 = std::sinh(d - next) / whole, b1 = std::sinh(next) / whole;
        add(a0, b0, a1, b1, weight);
        if (i + 1 < pieces) {
            add(a1, b1, a1, b1, 1);
        }
    }
    return piecewise_knots(pieces);
}

} // namespace

ConicArc make_conic_arc(std::vector<double> start, std::vector<double> end, const Point2 &chord,
                        const Point2 &middle, const DoubleDouble &weight, const PlaneMap &to_space) {
    const DoubleDouble below = DoubleDouble(1) - weight, above = DoubleDouble(1) + weight;
    if (!(above.value() > 0)) {
        fail(Status::conic,
             "the arc would pass through infinity: its middle weight would be %s, expected more "
             "than -1",
             Number(weight.value()).text);
    }
    ConicArc arc{std::move(start),
                 std::move(end),
                 to_space(middle),
                 weight.value(),
                 below.value(),
                 above.value(),
                 {},
                 {}};
    if (arc.below > 0) {
        const DoubleDouble squared = below * above, sine = square_root(squared);
        arc.u = to_space({(weight * middle.x - chord.x * DoubleDouble(0.5)) / squared,
                          (weight * middle.y - chord.y * DoubleDouble(0.5)) / squared});
        arc.v = to_space({middle.x / sine, middle.y / sine});
    }
    return arc;
}

SplinePtr conic_curve(std::span<const ConicArc> arcs, int32_t form) {
    const auto dim = static_cast<int>(arcs.front().start.size());
    Net net;
    net.add(arcs.front().start, 1);
    KnotVectorPtr axis;
    for (const ConicArc &conic : arcs) {
        axis = conic.below > 0 ? append_ellipse(net, conic, form) : append_hyperbola(net, conic);
        net.add(conic.end, 1);
    }
    if (arcs.size() > 1) {
        axis = piecewise_knots(std::ssize(net.weights) / 2);
    }
    return make_shape({std::move(axis)}, dim, std::move(net.points), std::move(net.weights));
}

SplinePtr conic_segment(int dim, const double *p0, const double *p1, const double *p2, double weight) {
    return make_shape({piecewise_knots(1)}, dim, joined(dim, {p0, p1, p2}), {1, weight, 1});
}

SplinePtr conic_by_shape_factor(int dim, const double *p0, const double *p1, const double *p2,
                                double factor) {
    if (!(factor >= 0)) {
        fail(Status::factor, "shape_factor = %s, expected 0 to infinity", Number(factor).text);
    }
    if (factor == 0) {
        return polyline(dim, joined(dim, {p0, p2}), even_params(2));
    }
    if (std::isinf(factor)) {
        return polyline(dim, joined(dim, {p0, p1, p2}), even_params(3));
    }
    return conic_segment(dim, p0, p1, p2, std::sqrt(factor));
}

} // namespace nrb::build
