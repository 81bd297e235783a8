// SPDX-License-Identifier: MIT
#include "io/iges/geometry/placement.h"

#include <cmath>

namespace nrb::io::iges {
namespace {

// The relative accuracy of matrices in files.
constexpr double matrix_digits = 1e-9;

bool across(const Vector3 &a, const Vector3 &b) noexcept {
    return std::fabs(dot(a, b)) <= matrix_digits * length(a) * length(b);
}
bool as_long(const Vector3 &a, double length_of_other) noexcept {
    return std::fabs(length(a) - length_of_other) <= matrix_digits * length_of_other;
}

} // namespace

std::array<double, 3> Placement::point(std::array<double, 3> x) const noexcept {
    if (transform) {
        x = transform->apply(x);
    }
    for (double &value : x) {
        value *= factor;
    }
    return x;
}

Vector3 Placement::vector(const Vector3 &v) const noexcept {
    std::array<double, 3> x = {v.x, v.y, v.z};
    if (transform) {
        x = Transform{transform->r, {}}.apply(x);
    }
    return {factor * x[0], factor * x[1], factor * x[2]};
}

PlaneImage Placement::plane(const std::array<double, 3> &origin, const Vector3 &x, const Vector3 &y) const {
    Vector3 along = vector(x), beside = vector(y);
    if (parameter_plane) {
        along.z = beside.z = 0;
    }
    const Vector3 normal = cross(along, beside);
    const double length_of_x = length(along);
    PlaneImage image;
    image.similar = length_of_x > 0 && as_long(beside, length_of_x) && across(along, beside) &&
                    (!parameter_plane || normal.z > 0);
    if (image.similar) {
        const double axis[3] = {normal.x, normal.y, normal.z}, way[3] = {along.x, along.y, along.z};
        image.scale = as_long(along, factor) ? factor : length_of_x;
        image.frame = build::make_placement(dim(), point(origin).data(), parameter_plane ? nullptr : axis,
                                            way, "centre");
    }
    return image;
}

double Placement::scale() const noexcept {
    if (!transform) {
        return factor;
    }
    const Vector3 x = vector({1, 0, 0}), y = vector({0, 1, 0}), z = vector({0, 0, 1});
    const double size = as_long(x, factor) ? factor : length(x);
    const bool similar = as_long(y, size) && as_long(z, size) && across(x, y) && across(y, z) && across(z, x);
    return similar ? size : 0;
}

bool Placement::mirrors() const noexcept {
    return dot(cross(vector({1, 0, 0}), vector({0, 1, 0})), vector({0, 0, 1})) < 0;
}

build::Placement direction_frame(const std::array<double, 3> &origin, const Vector3 &x, int dim) {
    const double way[3] = {x.x, x.y, x.z};
    if (dim == 2) {
        return build::make_placement(2, origin.data(), nullptr, way, "origin");
    }
    const build::Placement z = build::make_placement(3, origin.data(), way, nullptr, "origin");
    return {z.origin, z.z, z.x, z.y, 3, z.z_rest, z.x_rest, z.y_rest};
}

} // namespace nrb::io::iges
