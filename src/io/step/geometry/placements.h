// SPDX-License-Identifier: MIT
// Points, directions and placements.
#pragma once

#include "build/placement.h"
#include "io/step/entities.h"

#include <array>
#include <optional>

namespace nrb::io::step {

struct Point {
    std::array<double, 3> x{};
    int dim = 3; // 2 or 3
};

// All take what an attribute of `owner` names, and throw Status::syntax for anything else. Coordinates are multiplied
// by `length`.
Point read_point(Entities &entities, int64_t number, const Attributes &owner, const char *attribute,
                 double length);
Point read_point(Entities &entities, const Instance &instance, double length);
// Of any length but 0; not multiplied.
Point read_direction(Entities &entities, int64_t number, const Attributes &owner, const char *attribute);
// The direction that the next attribute names, if it names one; the last attributes may be left out.
std::optional<Point> read_optional(Entities &entities, Attributes &attributes, const char *name);
struct Vector {
    Point direction;  // of any length
    double magnitude; // multiplied by `length`

    // Without any rounding where the magnitude is nrb::length() of the direction.
    [[nodiscard]] Vector3 value() const noexcept;
};
Vector read_vector(Entities &entities, int64_t number, const Attributes &owner, const char *attribute,
                   double length);

// The frame that ISO 10303-42 builds from directions of Z and X that may be missing: Z is (0, 0, 1) then; X
// is the part across Z of (1, 0, 0), or of (0, 1, 0) where Z is parallel to that. A reference direction that
// is parallel to the axis counts as missing.
build::Placement space_frame(const Point &origin, const std::optional<Point> &axis,
                             const std::optional<Point> &reference);
// The frame of axis2_placement_2d and _3d, which is space_frame() in space.
build::Placement read_placement(Entities &entities, int64_t number, const Attributes &owner,
                                const char *attribute, double length);
// A point and a direction, (0, 0, 1) where it is missing; X is any.
build::Placement read_axis(Entities &entities, int64_t number, const Attributes &owner, const char *attribute,
                           double length);

} // namespace nrb::io::step
