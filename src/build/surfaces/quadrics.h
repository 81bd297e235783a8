// SPDX-License-Identifier: MIT
// Quadrics and the torus.
#pragma once

#include "build/conics/angle.h"
#include "build/placement.h"
#include "spline/spline.h"

#include <cstdint>

namespace nrb::build {

// The surfaces that nurbs.h describes. Axis 0 is the arc over `turn`, in one of the arc_ forms. All throw
// Status::form, not_representable, and Status::length, naming the argument.

// Between the latitudes south and north. Throws Status::angle as well.
SplinePtr spherical_patch(const Placement &place, double radius, const Turn &turn, double south, double north,
                          int32_t form);
SplinePtr ellipsoid(const Placement &place, double radius_x, double radius_y, double radius_z, int32_t form);
SplinePtr sphere(const Placement &place, double radius, int32_t form);
SplinePtr cylinder(const Placement &place, double radius, double height, const Turn &turn, int32_t form);
SplinePtr cone(const Placement &place, double base_radius, double top_radius, double height, const Turn &turn,
               int32_t form);
SplinePtr torus(const Placement &place, double major_radius, double minor_radius, const Turn &turn,
                const Turn &tube, int32_t form);
SplinePtr paraboloid(const Placement &place, double radius_x, double radius_y, double height,
                     const Turn &turn, int32_t form);
SplinePtr saddle(const Placement &place, double radius_x, double radius_y, double height);

struct HyperboloidSize {
    double radius_x;
    double radius_y;
    double radius_z;
    double bottom;
    double top;
    bool two_sheets;
};
SplinePtr hyperboloid(const Placement &place, const HyperboloidSize &size, const Turn &turn, int32_t form);

} // namespace nrb::build
