// SPDX-License-Identifier: MIT
// Splines as entities 126 and 128.
#pragma once

#include "io/iges/write/file_text.h"
#include "spline/spline.h"

namespace nrb::io::iges {

// Bit for bit as the spline has its numbers, if `length` is 1, by which the points are multiplied. Knots that are not clamped stay
// so, and the parameter range is the domain. A spline of the plane is one of a parameter plane. Begins an entity, which is to be
// ended. Precondition: check_writable().
int64_t begin_spline(FileText &text, const Spline &spline, std::string_view status, double length,
                     int64_t level = 0);

} // namespace nrb::io::iges
