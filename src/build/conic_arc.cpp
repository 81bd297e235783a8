#include "build/conic_arc.h"

#include "base/error.h"
#include "build/arc.h"
#include "build/make_shape.h"
#include "build/polylines.h"

#include <cmath>
#include <initializer_list>
#include <utility>

namespace nrb {

namespace {

// Control points of one degree with weights, ends of neighbours taken together.
struct Net {
    std::vector<double> points;
    std::vector<double> weights;

    void add(const std::vector<double> &point, double weight) {
        points.insert(points.end(), point.begin(), point.end());
        weights.push_back(weight);
    }
};

// The picture of the arc: a circle from the angle 0 on, a hyperbola from u = 0 on, or else the arc itself.
Arc picture(const ConicArc &conic, int32_t form) {
    const double w = conic.weight;
    if (w < 1) {
        const double angle = 4 * std::atan2(std::sqrt(1 - w), std::sqrt(1 + w));
        return unit_arc({Angle::from_radians(0), Angle::from_radians(angle)}, form);
    }
    return unit_hyperbola(0, w == 1 ? 1 : 2 * std::acosh(w));
}

// A + (x - 1) U + y V: the affine map that takes the picture's ends to A and B, and its homogeneous control point
// (cos a, sin a; cos a), or (cosh d, sinh d; cosh d), to that of the arc. The first column is U sin^2 a, the second
// V sin a.
class PictureMap {
public:
    explicit PictureMap(const ConicArc &conic) : conic_(conic) {
        const double w = conic.weight;
        const double squared = (1 - w) * (1 + w); // sin^2 a, -sinh^2 d
        v_factor_ = 1 / std::sqrt(std::fabs(squared));
        u_factor_ = 1 / squared;
    }
    [[nodiscard]] std::vector<double> point(double x, double y) const {
        std::vector<double> point(conic_.start);
        for (size_t c = 0; c < point.size(); ++c) {
            const double chord = conic_.end[c] - conic_.start[c];
            const double u = u_factor_ * (conic_.weight * conic_.middle[c] - chord / 2);
            point[c] += (x - 1) * u + y * (v_factor_ * conic_.middle[c]);
        }
        return point;
    }

private:
    const ConicArc &conic_;
    double u_factor_;
    double v_factor_;
};

void add_triangle_middle(Net &net, const ConicArc &conic) {
    std::vector<double> point(conic.start);
    for (size_t c = 0; c < point.size(); ++c) {
        point[c] += conic.middle[c] / conic.weight;
    }
    net.add(point, conic.weight);
}

std::vector<double> joined(int dim, std::initializer_list<const double *> points) {
    std::vector<double> all;
    for (const double *p : points) {
        all.insert(all.end(), p, p + dim);
    }
    return all;
}

// All control points but the first.
void append(Net &net, const ConicArc &conic, const Arc &picture) {
    if (picture.points.size() == 3) {
        add_triangle_middle(net, conic);
    } else {
        const PictureMap map(conic);
        for (size_t i = 1; i + 1 < picture.points.size(); ++i) {
            const ArcPoint &p = picture.points[i];
            net.add(map.point(p.x, p.y), p.weight);
        }
    }
    net.add(conic.end, 1);
}

} // namespace

SplinePtr conic_curve(std::span<const ConicArc> arcs, int32_t form) {
    const auto dim = static_cast<int>(arcs.front().start.size());
    Net net;
    net.add(arcs.front().start, 1);
    KnotVectorPtr axis;
    for (const ConicArc &conic : arcs) {
        if (!(conic.weight > -1)) {
            fail(NURBS_ERROR_CONIC, "the arc would pass through infinity");
        }
        const Arc image = picture(conic, form);
        axis = image.axis;
        append(net, conic, image);
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
        fail(NURBS_ERROR_FACTOR, "shape_factor = %s, expected 0 to infinity", Number(factor).text);
    }
    if (factor == 0) {
        return polyline(dim, joined(dim, {p0, p2}), even_params(2));
    }
    if (std::isinf(factor)) {
        return polyline(dim, joined(dim, {p0, p1, p2}), even_params(3));
    }
    return conic_segment(dim, p0, p1, p2, std::sqrt(factor));
}

} // namespace nrb
