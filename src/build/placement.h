// Where a shape stands: an origin and a frame of unit vectors.
#pragma once

#include "numeric/double_double.h"
#include "numeric/vector3.h"

#include <cstdint>

namespace nrb::build {

// The frame is known to twice the precision, so that shapes do not lean or shear by its rounding.
struct Placement {
    Vector3 origin;
    Vector3 x; // rounded
    Vector3 y;
    Vector3 z;
    int dim;             // 2 or 3
    Vector3 x_rest = {}; // what the rounding left
    Vector3 y_rest = {};
    Vector3 z_rest = {};

    // origin + a x + b y + c z, `dim` coordinates, each rounded as if formed in twice the precision.
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

// As nurbs.h has it for the curves of its group: origin, axis and x have `dim` coordinates each, or are null.
// Throws Status::dimension, point_not_finite, direction; `name` is that of the origin in messages.
Placement make_placement(int32_t dim, const double *origin, const double *axis, const double *x,
                         const char *name);

// Throws Status::point_not_finite, naming the coordinate.
void check_point(const double *point, int64_t dim, const char *name);
// Finite, and not 0; throws Status::direction.
void check_direction(const double *direction, int64_t dim, const char *name);
// Finite and positive; throws Status::length.
void check_positive_length(double length, const char *name);

} // namespace nrb::build
