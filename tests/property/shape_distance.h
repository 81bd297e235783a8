// The distance of a point from a shape with the numbers of nurbs_recognize(), in long double by its
// definition.
#pragma once

#include "support/frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <nurbs/nurbs.h>
#include <vector>

namespace support {

struct FoundShape {
    int32_t kind = 0;
    double placement[9] = {};
    double sizes[3] = {};
    double deviation = 0;
};

using Function = std::function<long double(long double)>;

// By the golden section. Precondition: f falls and then rises.
inline long double least_between(const Function &f, long double a, long double b) {
    const long double golden = (std::sqrt(5.0L) - 1) / 2;
    for (int i = 0; i < 110; ++i) {
        const long double x = b - golden * (b - a), y = a + golden * (b - a);
        f(x) < f(y) ? b = y : a = x;
    }
    return f((a + b) / 2);
}

// The least value over an interval: that of all local ones between many places.
inline long double least_value(const Function &f, long double low, long double high) {
    const int n = 256;
    std::vector<long double> places, values;
    for (int i = 0; i <= n; ++i) {
        places.push_back(low + (high - low) * i / n);
        values.push_back(f(places.back()));
    }
    long double least = std::min(values.front(), values.back());
    for (size_t i = 1; i < n; ++i) {
        if (values[i] <= values[i - 1] && values[i] <= values[i + 1]) {
            least = std::min(least, least_between(f, places[i - 1], places[i + 1]));
        }
    }
    return least;
}

inline long double conic_distance(const FoundShape &shape, long double x, long double y) {
    const long double a = shape.sizes[0], b = shape.sizes[1];
    if (shape.kind == NURBS_SHAPE_ELLIPSE) {
        return least_value(
            [&](long double t) { return std::hypot(a * std::cos(t) - x, b * std::sin(t) - y); }, -4, 4);
    }
    const auto side = [&](long double t) { // the curve as a function of y
        return shape.kind == NURBS_SHAPE_PARABOLA ? t * t / (4 * a) : a * std::hypot(1.0L, t / b);
    };
    const long double reach = std::fabs(side(y) - x);
    return least_value([&](long double t) { return std::hypot(side(t) - x, t - y); }, y - reach, y + reach);
}

inline long double shape_distance(const FoundShape &shape, const std::vector<long double> &point) {
    const double *q = shape.placement;
    Vector p{point[0] - q[0], point[1] - q[1], (point.size() > 2 ? point[2] : 0) - q[2]};
    if (shape.kind == NURBS_SHAPE_POINT) {
        return std::sqrt(dot(p, p));
    }
    if (shape.kind == NURBS_SHAPE_SPHERE) {
        return std::fabs(std::sqrt(dot(p, p)) - shape.sizes[0]);
    }
    const Vector axis = unit({q[3], q[4], q[5]});
    const long double z = dot(p, axis);
    const Vector across = minus(p, times(z, axis));
    const long double s = std::sqrt(dot(across, across)), a = shape.sizes[0];
    switch (shape.kind) {
    case NURBS_SHAPE_LINE:
        return s;
    case NURBS_SHAPE_PLANE:
        return std::fabs(z);
    case NURBS_SHAPE_CIRCLE:
        return std::hypot(s - a, z);
    case NURBS_SHAPE_CYLINDER:
        return std::fabs(s - a);
    case NURBS_SHAPE_CONE: {
        const long double along = s * std::sin(a) + z * std::cos(a);
        return along > 0 ? std::fabs(s * std::cos(a) - z * std::sin(a)) : std::hypot(s, z);
    }
    case NURBS_SHAPE_TORUS: {
        const long double b = shape.sizes[1], d = std::hypot(s - a, z);
        const bool inner = b > a && (a - s) * b > a * d; // the nearest point is on the part beyond the axis
        return inner ? std::hypot(s, std::fabs(z) - std::sqrt((b - a) * (b + a))) : std::fabs(d - b);
    }
    default:
        break;
    }
    const Vector given{q[6], q[7], q[8]};
    const Vector x = unit(minus(given, times(dot(given, axis), axis)));
    const Vector y{axis[1] * x[2] - axis[2] * x[1], axis[2] * x[0] - axis[0] * x[2],
                   axis[0] * x[1] - axis[1] * x[0]};
    return std::hypot(conic_distance(shape, dot(p, x), dot(p, y)), z);
}

} // namespace support
