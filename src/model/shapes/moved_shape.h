// SPDX-License-Identifier: MIT
// Curves and surfaces under motions that may scale and mirror.
#pragma once

#include "model/shapes/surface_shape.h"

#include <array>

namespace nrb::model {

// x -> M x + t. The columns of M are at right angles and of one length, but for rounding.
struct Similarity {
    std::array<Vector3, 3> columns{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    Vector3 shift{};

    [[nodiscard]] Vector3 turned(const Vector3 &x) const noexcept {
        return x.x * columns[0] + x.y * columns[1] + x.z * columns[2];
    }
    [[nodiscard]] Vector3 point(const Vector3 &x) const noexcept { return turned(x) + shift; }
    [[nodiscard]] double scale() const noexcept; // 1 if it is that but for rounding
    [[nodiscard]] bool mirrors() const noexcept;
};

// The image at every parameter, exact but for rounding. Curves keep their kind. Precondition: a curve of space.
CurveShapePtr moved(const CurveShapePtr &curve, const Similarity &motion);

// The same; the normals are those of the image by its own parameters. Surfaces keep their kind where it has these parameters: planes,
// cylinders and cones that are scaled, whose parameters are lengths, and surfaces around an axis that are mirrored become the
// extrusions and surfaces of revolution that have them.
SurfaceShapePtr moved(const SurfaceShapePtr &surface, const Similarity &motion);

} // namespace nrb::model
