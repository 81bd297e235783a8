// SPDX-License-Identifier: MIT
// Where and in which unit the numbers of an entity lie.
#pragma once

#include "build/placement.h"
#include "io/iges/transform.h"
#include "numeric/vector3.h"

#include <optional>

namespace nrb::io::iges {

// A plane of a definition space where it lies: coordinates (a, b) at frame origin + scale (a X + b Y) if it is `similar`,
// that is, if lengths and angles in it stay as they are but for 1e-9 and one factor.
struct PlaneImage {
    bool similar = false;
    double scale = 1;
    build::Placement frame{};
};

struct Placement {
    std::optional<Transform> transform{};
    double factor = 1;            // applied after the transform
    bool parameter_plane = false; // two coordinates only

    [[nodiscard]] int dim() const noexcept { return parameter_plane ? 2 : 3; }
    [[nodiscard]] std::array<double, 3> point(std::array<double, 3> x) const noexcept;
    // Without the translation.
    [[nodiscard]] Vector3 vector(const Vector3 &v) const noexcept;
    // Of the plane through `origin` with the unit vectors x and y across each other.
    [[nodiscard]] PlaneImage plane(const std::array<double, 3> &origin, const Vector3 &x,
                                   const Vector3 &y) const;
    // What the lengths of space are multiplied by: 0 if that is not the same for all directions.
    [[nodiscard]] double scale() const noexcept;
    // Whether the image of a right-handed frame is left-handed.
    [[nodiscard]] bool mirrors() const noexcept;
};

// A frame at a point with X along a direction; Y and Z are any. Throws Status::direction, point_not_finite.
build::Placement direction_frame(const std::array<double, 3> &origin, const Vector3 &x, int dim);

} // namespace nrb::io::iges
