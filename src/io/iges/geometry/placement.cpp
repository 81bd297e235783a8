// SPDX-License-Identifier: MIT
#include "io/iges/geometry/placement.h"

namespace nrb::io::iges {

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

build::Placement direction_frame(const std::array<double, 3> &origin, const Vector3 &x, int dim) {
    const double way[3] = {x.x, x.y, x.z};
    if (dim == 2) {
        return build::make_placement(2, origin.data(), nullptr, way, "origin");
    }
    const build::Placement z = build::make_placement(3, origin.data(), way, nullptr, "origin");
    return {z.origin, z.z, z.x, z.y, 3, z.z_rest, z.x_rest, z.y_rest};
}

} // namespace nrb::io::iges
