// SPDX-License-Identifier: MIT
// Where and in which unit the numbers of an entity lie.
#pragma once

#include "build/placement.h"
#include "io/iges/transform.h"
#include "numeric/vector3.h"

#include <optional>

namespace nrb::io::iges {

struct Placement {
    std::optional<Transform> transform{};
    double factor = 1;            // applied after the transform
    bool parameter_plane = false; // two coordinates only

    [[nodiscard]] int dim() const noexcept { return parameter_plane ? 2 : 3; }
    [[nodiscard]] std::array<double, 3> point(std::array<double, 3> x) const noexcept;
    // Without the translation.
    [[nodiscard]] Vector3 vector(const Vector3 &v) const noexcept;
};

// A frame at a point with X along a direction; Y and Z are any. Throws Status::direction, point_not_finite.
build::Placement direction_frame(const std::array<double, 3> &origin, const Vector3 &x, int dim);

} // namespace nrb::io::iges
