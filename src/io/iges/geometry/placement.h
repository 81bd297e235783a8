// SPDX-License-Identifier: MIT
// Placement and unit of the coordinates of an entity.
#pragma once

#include "build/placement.h"
#include "io/iges/transform.h"
#include "numeric/vector3.h"

#include <optional>

namespace nrb::io::iges {

// The image of a plane of a definition space. It is `similar` if lengths and angles in it are preserved up to
// one factor and a relative error of 1e-9. Then the point (a, b) has the image: frame origin + scale
// (a X + b Y).
struct PlaneImage {
    bool similar = false;
    double scale = 1;
    build::Placement frame{};
};

struct Placement {
    std::optional<Transform> transform{};
    double factor = 1;            // applied after the transform
    bool parameter_plane = false; // only two coordinates

    [[nodiscard]] int dim() const noexcept { return parameter_plane ? 2 : 3; }
    [[nodiscard]] std::array<double, 3> point(std::array<double, 3> x) const noexcept;
    // The image of a vector, without the translation.
    [[nodiscard]] Vector3 vector(const Vector3 &v) const noexcept;
    // The image of the plane through `origin` with the orthogonal unit vectors x and y.
    [[nodiscard]] PlaneImage plane(const std::array<double, 3> &origin, const Vector3 &x,
                                   const Vector3 &y) const;
    // The factor of all lengths; 0 if it differs between directions.
    [[nodiscard]] double scale() const noexcept;
    // Whether the image of a right-handed frame is left-handed.
    [[nodiscard]] bool mirrors() const noexcept;
};

// A frame at a point with X along a direction; Y and Z are arbitrary. Throws Status::direction,
// point_not_finite.
build::Placement direction_frame(const std::array<double, 3> &origin, const Vector3 &x, int dim);

} // namespace nrb::io::iges
