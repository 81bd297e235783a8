// SPDX-License-Identifier: MIT
// What the writers of all formats state of splines.
#pragma once

#include "spline/spline.h"

#include <string_view>
#include <vector>

namespace nrb::io {

// Throws for what no entity of `format` can hold: Status::axes for volumes, dimension for points that are neither of
// space nor those of a curve of the plane, degree for
// 0, weight_sign for homogeneous points whose weight is not positive.
void check_writable(const Spline &spline, const char *format);

// The same of the surface of a face, naming that.
void check_surface(const Spline &surface, size_t face, const char *format);

// Whether the weights differ, so that they mean something.
bool has_weights(const Spline &spline);
std::vector<double> weights_of(const Spline &spline);

// Whether the first and the last layer of control points are the same, or the axis could be declared periodic: files do not keep
// whether it is.
bool closed(const Spline &spline, int k);

// The name of an item without blanks around it; none for `usual`, which readers give to it if it has none.
std::string_view stated_name(std::string_view name, std::string_view usual);

} // namespace nrb::io
