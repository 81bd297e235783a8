// SPDX-License-Identifier: MIT
#include "recognize/recognize.h"

#include "base/numbers.h"
#include "base/representable.h"
#include "base/watch.h"
#include "recognize/shape_bound.h"
#include "recognize/shape_fit.h"
#include "recognize/shape_refine.h"
#include "recognize/shape_samples.h"
#include "spline/kind.h"
#include "spline/scaled.h"

#include <algorithm>
#include <cmath>

namespace nrb::recognize {

namespace {

void check_admitted(const Spline &spline) {
    if (spline.axes() > 2) {
        fail(Status::axes, "g has %d axes, expected a curve or surface", spline.axes());
    }
    check_dimension(spline, 2, 3);
}

// The exponent of the largest half-extent of the box of the control points or, if that is 0, of the largest
// coordinate.
int size_exponent(const Spline &spline) {
    double largest = 0, extent = 0;
    for (int c = 0; c < spline.dim(); ++c) {
        double low = infinity, high = -low;
        for (int64_t i = 0; i < spline.point_count(); ++i) {
            const double x = spline.coordinate(i, c);
            if (std::isfinite(x)) {
                low = std::min(low, x);
                high = std::max(high, x);
                largest = std::max(largest, std::abs(x));
            }
        }
        extent = std::max(extent, high / 2 - low / 2);
    }
    const double size = extent > 0 && std::isfinite(extent) ? extent : largest;
    return size > 0 ? std::ilogb(size) : 0;
}

void scale_back(Recognition &found, int exponent) {
    Shape &shape = found.shape;
    std::vector<double *> lengths{&shape.origin.x, &shape.origin.y, &shape.origin.z, &found.deviation};
    if (shape.kind != shape_cone) {
        lengths.insert(lengths.end(), {&shape.sizes[0], &shape.sizes[1]});
    }
    for (double *length : lengths) {
        *length = std::ldexp(*length, exponent);
        require_representable({length, 1}, "shape");
    }
}

constexpr int32_t curves[] = {shape_point,    shape_line,    shape_circle,
                              shape_parabola, shape_ellipse, shape_hyperbola};
constexpr int32_t surfaces[] = {shape_point,    shape_line, shape_plane, shape_sphere,
                                shape_cylinder, shape_cone, shape_torus};

// Whether some sample is farther than `width` from the line that passes through the centre of the box of the
// samples and the sample farthest from it.
bool wider_than(const ShapeSamples &samples, double width) {
    const auto far =
        std::max_element(samples.points.begin(), samples.points.end(),
                         [](const Vector3 &a, const Vector3 &b) { return dot(a, a) < dot(b, b); });
    const Vector3 along = unit(*far);
    return length(*far) > 0 && std::any_of(samples.points.begin(), samples.points.end(),
                                           [&](const Vector3 &p) { return length(cross(along, p)) > width; });
}

// Whether the samples of a surface show at once that it is larger than a point, or wider than a line. If all
// samples were within the tolerance of a point, half the diagonal of their box would be less than twice the
// tolerance. If they were within the tolerance of a line, they would be within a small multiple of it of the
// line from the centre of their box to the sample farthest from there.
bool too_large(int32_t kind, const ShapeSamples &samples, double tolerance) {
    if (kind == shape_point) {
        return samples.size > 2 * tolerance;
    }
    return wider_than(samples, 16 * tolerance);
}

// Whether the samples differ only by rounding from a point (for kind line), or from a line or point
// (for kind plane), and therefore define no direction, or no plane.
bool undetermined(int32_t kind, const ShapeSamples &samples) {
    const double rounding = 64 * eps * (length(samples.centre) + samples.size);
    return (kind == shape_line && samples.size <= rounding) ||
           (kind == shape_plane && !wider_than(samples, rounding));
}

// Whether a shape of a kind is within the tolerance.
bool find(int32_t kind, const Spline &spline, const ShapeSamples &samples, double tolerance,
          Recognition &found) {
    const bool shrunk = kind == shape_point || kind == shape_line;
    if (spline.axes() == 2 && shrunk && too_large(kind, samples, tolerance)) {
        return false;
    }
    const Shape fitted = fitted_shape(kind, samples, spline.dim(), tolerance);
    if (fitted.kind == shape_none || !(largest_distance(fitted, samples.points) <= 1.01 * tolerance)) {
        return false;
    }
    found.shape = placed_shape(fitted, samples, spline.dim());
    found.deviation = distance_from(spline, found.shape, tolerance).upper;
    return std::isfinite(found.deviation) && found.deviation <= tolerance;
}

} // namespace

Recognition recognize(const Spline &given, double tolerance) {
    check_admitted(given);
    const Spline &spline = given.effective();
    const int exponent = size_exponent(spline);
    const SplinePtr unit = scaled(spline, {.coordinates = -exponent});
    require_representable(unit->points(), "scaled points");
    const ShapeSamples samples = shape_samples(*unit);
    const double reach = std::ldexp(tolerance, -exponent);
    if (samples.points.empty()) {
        return {};
    }
    Recognition found;
    const auto kinds =
        spline.axes() == 1 ? std::span<const int32_t>(curves) : std::span<const int32_t>(surfaces);
    for (const int32_t kind : kinds) {
        const Phase phase;
        if (undetermined(kind, samples)) {
            return {};
        }
        if (find(kind, *unit, samples, reach, found)) {
            scale_back(found, exponent);
            return found;
        }
    }
    return {};
}

} // namespace nrb::recognize
