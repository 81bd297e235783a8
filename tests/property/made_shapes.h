// Simple shapes as rational splines, from their control points, and other forms of the same shape.
#pragma once

#include "support/generators.h"
#include "support/handle.h"

#include <array>
#include <cmath>

namespace support {

// A point of a plane curve, x and y or the distance from an axis and the height along it.
struct PlanePoint {
    double x, y, w;
};
struct PlaneCurve {
    int degree = 2;
    std::vector<double> knots;
    std::vector<PlanePoint> points;
};

// `pieces` pieces of degree 2 from points that alternate ends and middles.
inline PlaneCurve pieces_of(std::vector<PlanePoint> points) {
    PlaneCurve curve{2, {0, 0, 0}, std::move(points)};
    const auto pieces = static_cast<int>(curve.points.size()) / 2;
    for (int i = 1; i <= pieces; ++i) {
        curve.knots.insert(curve.knots.end(), i == pieces ? 3 : 2, static_cast<double>(i) / pieces);
    }
    return curve;
}

// centre + (a cos, b sin).
inline PlaneCurve ellipse_arc(double cx, double cy, double a, double b, double start, double sweep) {
    const auto pieces = static_cast<int>(std::ceil(std::fabs(sweep) / 1.58));
    const double half = sweep / pieces / 2, w = std::cos(half);
    std::vector<PlanePoint> points;
    for (int i = 0; i <= 2 * pieces; ++i) {
        const double angle = start + i * half, r = i % 2 == 0 ? 1 : 1 / w;
        points.push_back({cx + a * r * std::cos(angle), cy + b * r * std::sin(angle), i % 2 == 0 ? 1 : w});
    }
    return pieces_of(points);
}

// (t^2 / (4 f), t).
inline PlaneCurve parabola_arc(double f, double start, double end) {
    return pieces_of({{start * start / (4 * f), start, 1},
                      {start * end / (4 * f), (start + end) / 2, 1},
                      {end * end / (4 * f), end, 1}});
}

// (a cosh u, b sinh u).
inline PlaneCurve hyperbola_arc(double a, double b, double start, double end) {
    const double w = std::cosh((end - start) / 2), middle = (start + end) / 2;
    return pieces_of({{a * std::cosh(start), b * std::sinh(start), 1},
                      {a * std::cosh(middle) / w, b * std::sinh(middle) / w, w},
                      {a * std::cosh(end), b * std::sinh(end), 1}});
}

inline PlaneCurve segment(double x0, double y0, double x1, double y1) {
    return {1, {0, 0, 1, 1}, {{x0, y0, 1}, {x1, y1, 1}}};
}

inline SplineData in_space(const PlaneCurve &curve, int dim) {
    SplineData data{
        {curve.degree}, {static_cast<int64_t>(curve.points.size())}, {curve.knots}, dim, {}, {}, 0};
    for (const PlanePoint &p : curve.points) {
        data.points.insert(data.points.end(), {p.x, p.y});
        data.points.insert(data.points.end(), static_cast<size_t>(dim - 2), 0.0);
        data.weights.push_back(p.w);
    }
    return data;
}

// The product of a curve about the axis z, the rotation, and a profile of distances and heights.
inline SplineData revolved(const PlaneCurve &profile, double start, double sweep) {
    const PlaneCurve turn = ellipse_arc(0, 0, 1, 1, start, sweep);
    SplineData data{{2, profile.degree},
                    {static_cast<int64_t>(turn.points.size()), static_cast<int64_t>(profile.points.size())},
                    {turn.knots, profile.knots},
                    3,
                    {},
                    {},
                    0};
    for (const PlanePoint &t : turn.points) {
        for (const PlanePoint &p : profile.points) {
            data.points.insert(data.points.end(), {t.x * p.x, t.y * p.x, p.y});
            data.weights.push_back(t.w * p.w);
        }
    }
    return data;
}

inline SplineData parallelogram(double width, double height, double skew) {
    return {{1, 1},
            {2, 2},
            {{0, 0, 1, 1}, {0, 0, 1, 1}},
            3,
            {0, 0, 0, skew, height, 0, width, 0, 0, width + skew, height, 0},
            {},
            0};
}

struct MadeShape {
    int32_t kind;
    SplineData data;
    double sizes[2];
    double size; // of its box, about
};

// A curve or surface of the kind, round the origin, of a size near 1.
inline MadeShape made_shape(Random &random, int32_t kind, int dim) {
    const double a = random.between(0.5, 2), b = random.between(0.2, 0.9) * a;
    const double start = random.between(-3, 3), full = 2 * std::acos(-1.0);
    const double sweep = random.chance(30) ? full : random.between(0.3, full);
    switch (kind) {
    case NURBS_SHAPE_LINE:
        return {kind, in_space(segment(a, b, -b, a), dim), {0, 0}, 1};
    case NURBS_SHAPE_CIRCLE:
        return {kind, in_space(ellipse_arc(0, 0, a, a, start, sweep), dim), {a, 0}, a};
    case NURBS_SHAPE_ELLIPSE:
        return {kind, in_space(ellipse_arc(0, 0, a, b, start, std::max(sweep, 2.0)), dim), {a, b}, a};
    case NURBS_SHAPE_PARABOLA:
        return {kind, in_space(parabola_arc(b, -a, b), dim), {b, 0}, a};
    case NURBS_SHAPE_HYPERBOLA:
        return {kind, in_space(hyperbola_arc(a, b, -1.5, 1), dim), {a, b}, a};
    case NURBS_SHAPE_PLANE:
        return {kind, parallelogram(a, b, b), {0, 0}, a};
    case NURBS_SHAPE_SPHERE: {
        const bool whole = random.chance(50); // to the poles
        const double half = full / 4;
        return {kind,
                revolved(ellipse_arc(0, 0, a, a, whole ? -half : -0.5, whole ? 2 * half : 1.2), start, sweep),
                {a, 0},
                a};
    }
    case NURBS_SHAPE_CYLINDER:
        return {kind, revolved(segment(a, 0, a, 2 * b), start, sweep), {a, 0}, a};
    case NURBS_SHAPE_CONE: {
        const double angle = random.between(0.1, 1.3), from = random.chance(50) ? 0 : b, to = b + a;
        return {kind,
                revolved(segment(from * std::sin(angle), from * std::cos(angle), to * std::sin(angle),
                                 to * std::cos(angle)),
                         start, sweep),
                {angle, 0},
                to};
    }
    default: {
        const bool whole = random.chance(50);
        return {kind, revolved(ellipse_arc(a, 0, b, b, start, whole ? full : 2), start, sweep), {a, b}, a};
    }
    }
}

// Turned by a random rotation (in dimension 2 about z), scaled and moved.
struct Motion {
    std::array<double, 9> matrix;
    std::array<double, 3> offset;
};
inline Motion random_motion(Random &random, int dim, double scale, double offset) {
    double q[4];
    double norm = 0;
    for (int i = 0; i < 4; ++i) {
        q[i] = dim == 2 && (i == 1 || i == 2) ? 0 : random.between(-1, 1);
        norm += q[i] * q[i];
    }
    norm = std::sqrt(norm);
    const double w = q[0] / norm, x = q[1] / norm, y = q[2] / norm, z = q[3] / norm;
    Motion motion{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 2 * (x * y + z * w),
                   1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 2 * (x * z - y * w), 2 * (y * z + x * w),
                   1 - 2 * (x * x + y * y)},
                  {}};
    for (double &m : motion.matrix) {
        m *= scale;
    }
    for (double &o : motion.offset) {
        o = scale * offset * random.between(-1, 1);
    }
    return motion;
}
inline void move(SplineData &data, const Motion &motion) {
    const auto dim = static_cast<size_t>(data.dim);
    for (size_t i = 0; i < data.points.size(); i += dim) {
        const std::array<double, 3> p{data.points[i], data.points[i + 1], dim > 2 ? data.points[i + 2] : 0};
        for (size_t c = 0; c < dim; ++c) {
            data.points[i + c] = motion.offset[c] + motion.matrix[3 * c] * p[0] +
                                 motion.matrix[3 * c + 1] * p[1] + motion.matrix[3 * c + 2] * p[2];
        }
    }
}

// The same shape after some of: knots, a higher degree, the other direction, a Moebius map of the parameter,
// ends that are not clamped.
inline Handle disguised(Random &random, Handle g, int axes) {
    const auto become = [&g](nurbs_status status, nurbs *made) {
        require_ok(status);
        g.reset(made);
    };
    for (int32_t axis = 0; axis < axes; ++axis) {
        nurbs *out = nullptr;
        if (random.chance(40)) {
            const nurbs_status status = nurbs_elevate(g.get(), axis, random.whole(1, 2), &out);
            become(status, out);
        }
        if (random.chance(40)) {
            const nurbs_status status = nurbs_refine_uniform(g.get(), axis, random.whole(2, 3), &out);
            become(status, out);
        }
        if (random.chance(40)) {
            const nurbs_status status = nurbs_reverse(g.get(), axis, 0, &out);
            become(status, out);
        }
        if (random.chance(40)) {
            const nurbs_status status =
                nurbs_reparametrize_moebius(g.get(), axis, random.magnitude(0.1, 10), &out);
            become(status, out);
        }
        if (random.chance(20) &&
            nurbs_unclamp(g.get(), axis, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &out) ==
                NURBS_OK) {
            g.reset(out);
        }
    }
    return g;
}

// Declared periodic along the axes whose ends meet.
inline Handle periodic_where_closed(Handle g, int axes) {
    for (int32_t axis = 0; axis < axes; ++axis) {
        nurbs *out = nullptr;
        if (nurbs_make_periodic(g.get(), axis, 1e-15, nullptr, nullptr, &out) == NURBS_OK) {
            g.reset(out);
        }
    }
    return g;
}

} // namespace support
