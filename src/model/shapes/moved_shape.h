// SPDX-License-Identifier: MIT
// Images of curves and surfaces under similarities, which may scale and mirror.
#pragma once

#include "model/shapes/surface_shape.h"

#include <array>

namespace nrb::model {

// The map x -> M x + t. The columns of M are orthogonal and of equal length, to rounding.
struct Similarity {
    std::array<Vector3, 3> columns{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    Vector3 shift{};

    [[nodiscard]] Vector3 turned(const Vector3 &x) const noexcept {
        return x.x * columns[0] + x.y * columns[1] + x.z * columns[2];
    }
    [[nodiscard]] Vector3 point(const Vector3 &x) const noexcept { return turned(x) + shift; }
    [[nodiscard]] double scale() const noexcept; // 1 if it is that to rounding
    [[nodiscard]] bool mirrors() const noexcept;
};

// The image at equal parameters, exact but for rounding. Curves keep their kind. Precondition: a curve in
// space.
CurveShapePtr moved(const CurveShapePtr &curve, const Similarity &motion);

// The same for surfaces; normals are those of the image along its own S_u x S_v. A surface keeps its kind if
// the image with these parameters is of that kind. Otherwise it becomes an extrusion or a surface of
// revolution: scaled planes, cylinders and cones, because their parameters are lengths, and mirrored
// cylinders, cones, spheres and tori.
SurfaceShapePtr moved(const SurfaceShapePtr &surface, const Similarity &motion);

} // namespace nrb::model
