// SPDX-License-Identifier: MIT
// Splines as entities 126 and 128.
#pragma once

#include "io/iges/write/file_text.h"
#include "spline/spline.h"

namespace nrb::io::iges {

// Bit for bit as the spline has its numbers, if `length` is 1, by which the points are multiplied. Knots that are not clamped stay
// so, and the parameter range is the domain. A spline of the plane is one of a parameter plane. Begins an entity, which is to be
// ended. Preconditions: check_writable(), but for the dimension of 2.
int64_t begin_spline(FileText &text, const Spline &spline, std::string_view status, double length);

} // namespace nrb::io::iges
