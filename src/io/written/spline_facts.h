// SPDX-License-Identifier: MIT
// Properties of splines that the writers of all formats need.
#pragma once

#include "spline/spline.h"

#include <string_view>
#include <vector>

namespace nrb::io {

// Throws for a spline that no entity of `format` can hold: Status::axes for a volume; dimension unless its
// points are in space, or in the plane for a curve; degree for degree 0; weight_sign for a homogeneous point
// with a weight that is not positive.
void check_writable(const Spline &spline, const char *format);

// The same for the surface of a face; messages name the face.
void check_surface(const Spline &surface, size_t face, const char *format);

// Whether the weights differ from each other, so that they affect the shape.
bool has_weights(const Spline &spline);
std::vector<double> weights_of(const Spline &spline);

// Whether the first and the last layer of control points are equal, or the axis could be declared periodic.
// Files do not keep whether an axis is periodic.
bool closed(const Spline &spline, int k);

// The name of an item without blanks around it; empty if it is `usual`, which readers give to an item without
// a name.
std::string_view stated_name(std::string_view name, std::string_view usual);

} // namespace nrb::io
