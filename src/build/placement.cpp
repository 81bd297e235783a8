#include "build/placement.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace nrb {

namespace {

Vector3 vector_of(const double *v, int dim) noexcept {
    return {v[0], v[1], dim == 3 ? v[2] : 0};
}

double combined(double origin, double x, double y, double z, const Wide *factors) noexcept {
    const Wide parts = factors[0] * x + factors[1] * y + factors[2] * z;
    return (origin + parts).value();
}

void set_plane_frame(Placement &place, const double *axis, const double *x) {
    if (axis != nullptr) {
        fail(NURBS_ERROR_DIRECTION, "axis is given, expected NULL in dimension 2");
    }
    if (x != nullptr) {
        check_direction(x, 2, "x");
        place.x = unit({x[0], x[1], 0});
    }
    place.y = {-place.x.y, place.x.x, 0};
}

void set_space_frame(Placement &place, const double *axis, const double *x) {
    if (axis != nullptr) {
        check_direction(axis, 3, "axis");
        place.z = unit(scaled_to_one(vector_of(axis, 3)));
        place.x = any_normal(place.z);
    }
    if (x != nullptr) {
        check_direction(x, 3, "x");
        const Vector3 along = unit(scaled_to_one(vector_of(x, 3)));
        if (largest(cross(place.z, along)) <= 4 * 0x1p-52) {
            fail(NURBS_ERROR_DIRECTION, "x = (%s, %s, %s) is parallel to the axis", Number(x[0]).text,
                 Number(x[1]).text, Number(x[2]).text);
        }
        place.x = unit_across(along, place.z);
    }
    place.y = cross(place.z, place.x);
}

} // namespace

void Placement::point(const Wide &a, const Wide &b, const Wide &c, double *out) const noexcept {
    const Wide factors[3] = {a, b, c};
    out[0] = combined(origin.x, x.x, y.x, z.x, factors);
    out[1] = combined(origin.y, x.y, y.y, z.y, factors);
    if (dim == 3) {
        out[2] = combined(origin.z, x.z, y.z, z.z, factors);
    }
}

void check_point(const double *point, int64_t dim, const char *name) {
    for (int64_t i = 0; i < dim; ++i) {
        if (!std::isfinite(point[i])) {
            fail(NURBS_ERROR_POINT_NOT_FINITE, "%s[%lld] = %s is not finite", name, static_cast<long long>(i),
                 Number(point[i]).text);
        }
    }
}

void check_direction(const double *direction, int64_t dim, const char *name) {
    for (int64_t i = 0; i < dim; ++i) {
        if (!std::isfinite(direction[i])) {
            fail(NURBS_ERROR_DIRECTION, "%s[%lld] = %s is not finite", name, static_cast<long long>(i),
                 Number(direction[i]).text);
        }
    }
    if (std::all_of(direction, direction + dim, [](double d) { return d == 0; })) {
        fail(NURBS_ERROR_DIRECTION, "%s is zero, expected a direction", name);
    }
}

void check_length(double length, const char *name) {
    if (!std::isfinite(length) || !(length > 0)) {
        fail(NURBS_ERROR_LENGTH, "%s = %s, expected a finite length above 0", name, Number(length).text);
    }
}

Placement make_placement(int32_t dim, const double *origin, const double *axis, const double *x,
                         const char *name) {
    if (dim != 2 && dim != 3) {
        fail(NURBS_ERROR_DIMENSION, "dim = %d, expected 2 or 3", dim);
    }
    Placement place{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, dim};
    if (origin != nullptr) {
        check_point(origin, dim, name);
        place.origin = vector_of(origin, dim);
    }
    if (dim == 2) {
        set_plane_frame(place, axis, x);
    } else {
        set_space_frame(place, axis, x);
    }
    return place;
}

} // namespace nrb
