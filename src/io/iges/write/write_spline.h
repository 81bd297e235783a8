// SPDX-License-Identifier: MIT
// Writes splines as entities 126 and 128.
#pragma once

#include "io/iges/write/file_text.h"
#include "spline/spline.h"

namespace nrb::io::iges {

// Begins the entity of a spline, which the caller has to end. Points are multiplied by `length`; if that is
// 1, all numbers are written bit for bit. Knots that are not clamped remain so, and the parameter range is
// the domain. A spline of dimension 2 lies in a parameter plane. Precondition: check_writable().
int64_t begin_spline(FileText &text, const Spline &spline, std::string_view status, double length,
                     int64_t level = 0);

} // namespace nrb::io::iges
