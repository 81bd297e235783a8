// SPDX-License-Identifier: MIT
// The placement of a shape: an origin and a frame of unit vectors.
#pragma once

#include "numeric/double_double.h"
#include "numeric/vector3.h"

#include <cstdint>

namespace nrb::build {

// The frame is kept in double-double precision, so that its rounding does not tilt or shear shapes.
struct Placement {
    Vector3 origin;
    Vector3 x; // rounded
    Vector3 y;
    Vector3 z;
    int dim;             // 2 or 3
    Vector3 x_rest = {}; // the low parts, which rounding left out
    Vector3 y_rest = {};
    Vector3 z_rest = {};
    // The directions from which make_placement() made the frame, not normalized; 0: none was given. They
    // reproduce the frame exactly; the rounded x and z may not.
    Vector3 given_axis = {};
    Vector3 given_x = {};

    // The `dim` coordinates of origin + a x + b y + c z, each rounded as if computed in double-double
    // precision.
    void point(const DoubleDouble &a, const DoubleDouble &b, const DoubleDouble &c,
               double *out) const noexcept;

    // Coordinate c of the origin and of the frame.
    struct Component {
        double origin;
        DoubleDouble x;
        DoubleDouble y;
        DoubleDouble z;
    };
    [[nodiscard]] Component component(int c) const noexcept;
};

// The placement that nurbs.h defines for curves. Origin, axis and x have `dim` coordinates each, or are null.
// Throws Status::dimension, point_not_finite, direction; `name` names the origin in messages.
Placement make_placement(int32_t dim, const double *origin, const double *axis, const double *x,
                         const char *name);

// Throws Status::point_not_finite, naming the coordinate.
void check_point(const double *point, int64_t dim, const char *name);
// Throws Status::direction unless it is finite and not 0.
void check_direction(const double *direction, int64_t dim, const char *name);
// Throws Status::length unless it is finite and positive.
void check_positive_length(double length, const char *name);

} // namespace nrb::build
