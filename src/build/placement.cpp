// SPDX-License-Identifier: MIT
#include "build/placement.h"

#include "base/error.h"
#include "numeric/sum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::build {

namespace {

using WideVector = std::array<DoubleDouble, 3>;

DoubleDouble dot(const WideVector &a, const WideVector &b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
WideVector cross(const WideVector &a, const WideVector &b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// A unit vector; exact along the coordinate axes, as most axes of frames are.
WideVector unit(const WideVector &a) noexcept {
    for (size_t k = 0; k < 3; ++k) {
        if (a[(k + 1) % 3].high == 0 && a[(k + 2) % 3].high == 0) {
            WideVector along{};
            along[k] = std::copysign(1.0, a[k].high);
            return along;
        }
    }
    const DoubleDouble scale = DoubleDouble(1) / square_root(dot(a, a));
    return {a[0] * scale, a[1] * scale, a[2] * scale};
}
// The unit vector along the component of a perpendicular to the unit vector t.
WideVector unit_across(const WideVector &a, const WideVector &t) noexcept {
    const DoubleDouble part = dot(a, t);
    return unit(WideVector{a[0] - part * t[0], a[1] - part * t[1], a[2] - part * t[2]});
}

WideVector scaled_vector(const double *v, int dim) noexcept {
    const Vector3 scaled = scaled_to_one(vector_of(v, dim));
    return {scaled.x, scaled.y, scaled.z};
}

// The coordinate direction of the smallest component, the first one of equal ones.
WideVector least_direction(const WideVector &a) noexcept {
    const auto least = std::ranges::min_element(
                           a, {}, [](const DoubleDouble &component) { return std::fabs(component.high); }) -
                       a.begin();
    WideVector direction{};
    direction[static_cast<size_t>(least)] = 1;
    return direction;
}

// Adds a product: that of the high parts, its rounding error, and the products of a high with a low part.
void add_product(const DoubleDouble &a, const DoubleDouble &b, CompensatedSum &sum) noexcept {
    if (a.high == 0 || b.high == 0) { // frequent in planes and along the coordinate axes
        return;
    }
    const double product = a.high * b.high;
    sum.add(product);
    sum.rest += std::fma(a.high, b.high, -product) + (a.high * b.low + a.low * b.high);
}

void set_vector(const WideVector &v, Vector3 &rounded, Vector3 &rest) noexcept {
    rounded = {v[0].high, v[1].high, v[2].high};
    rest = {v[0].low, v[1].low, v[2].low};
}

void set_frame(Placement &place, const WideVector &x, const WideVector &y, const WideVector &z) noexcept {
    set_vector(x, place.x, place.x_rest);
    set_vector(y, place.y, place.y_rest);
    set_vector(z, place.z, place.z_rest);
}

void set_plane_frame(Placement &place, const double *axis, const double *x) {
    if (axis != nullptr) {
        fail(Status::direction, "axis is given, expected NULL in dimension 2");
    }
    if (x != nullptr) {
        check_direction(x, 2, "x");
        const WideVector along = unit(scaled_vector(x, 2));
        set_frame(place, along, {-along[1], along[0], 0}, {0, 0, 1});
    }
}

void set_space_frame(Placement &place, const double *axis, const double *x) {
    if (axis == nullptr && x == nullptr) {
        return;
    }
    WideVector z = {0, 0, 1}, along = {1, 0, 0};
    if (axis != nullptr) {
        check_direction(axis, 3, "axis");
        const WideVector given = scaled_vector(axis, 3);
        z = unit(given);
        along = least_direction(given);
    }
    if (x != nullptr) {
        check_direction(x, 3, "x");
        along = unit(scaled_vector(x, 3));
        const WideVector sine = cross(z, along);
        if (std::max({std::fabs(sine[0].high), std::fabs(sine[1].high), std::fabs(sine[2].high)}) <=
            4 * 0x1p-52) {
            fail(Status::direction, "x = (%s, %s, %s) is parallel to the axis", Number(x[0]).text,
                 Number(x[1]).text, Number(x[2]).text);
        }
    }
    const WideVector across = unit_across(along, z);
    set_frame(place, across, cross(z, across), z);
}

} // namespace

Placement::Component Placement::component(int c) const noexcept {
    switch (c) {
    case 0:
        return {origin.x, {x.x, x_rest.x}, {y.x, y_rest.x}, {z.x, z_rest.x}};
    case 1:
        return {origin.y, {x.y, x_rest.y}, {y.y, y_rest.y}, {z.y, z_rest.y}};
    default:
        return {origin.z, {x.z, x_rest.z}, {y.z, y_rest.z}, {z.z, z_rest.z}};
    }
}

void Placement::point(const DoubleDouble &a, const DoubleDouble &b, const DoubleDouble &c,
                      double *out) const noexcept {
    for (int i = 0; i < dim; ++i) {
        const Component frame = component(i);
        CompensatedSum sum{frame.origin};
        add_product(a, frame.x, sum);
        add_product(b, frame.y, sum);
        add_product(c, frame.z, sum);
        out[i] = sum.value();
    }
}

void check_point(const double *point, int64_t dim, const char *name) {
    for (int64_t i = 0; i < dim; ++i) {
        if (!std::isfinite(point[i])) {
            fail(Status::point_not_finite, "%s[%lld] = %s is not finite", name, static_cast<long long>(i),
                 Number(point[i]).text);
        }
    }
}

void check_direction(const double *direction, int64_t dim, const char *name) {
    for (int64_t i = 0; i < dim; ++i) {
        if (!std::isfinite(direction[i])) {
            fail(Status::direction, "%s[%lld] = %s is not finite", name, static_cast<long long>(i),
                 Number(direction[i]).text);
        }
    }
    if (std::all_of(direction, direction + dim, [](double d) { return d == 0; })) {
        fail(Status::direction, "%s is zero in its %lld components, expected a direction", name,
             static_cast<long long>(dim));
    }
}

void check_positive_length(double length, const char *name) {
    if (!std::isfinite(length) || !(length > 0)) {
        fail(Status::length, "%s = %s, expected a finite length above 0", name, Number(length).text);
    }
}

Placement make_placement(int32_t dim, const double *origin, const double *axis, const double *x,
                         const char *name) {
    if (dim != 2 && dim != 3) {
        fail(Status::dimension, "dim = %d, expected 2 or 3", dim);
    }
    Placement place{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, dim, {}, {}, {}, {}, {}};
    if (origin != nullptr) {
        check_point(origin, dim, name);
        place.origin = vector_of(origin, dim);
    }
    place.given_axis = axis == nullptr ? Vector3{} : vector_of(axis, dim);
    place.given_x = x == nullptr ? Vector3{} : vector_of(x, dim);
    if (dim == 2) {
        set_plane_frame(place, axis, x);
    } else {
        set_space_frame(place, axis, x);
    }
    return place;
}

} // namespace nrb::build
