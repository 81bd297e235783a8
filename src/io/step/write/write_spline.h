// SPDX-License-Identifier: MIT
// B-spline curves and surfaces as they are written.
#pragma once

#include "io/step/write/exchange_text.h"
#include "spline/spline.h"

namespace nrb::io::step {

// The name of an item without blanks around it; none for that which readers give to this instance if it has none.
std::string_view stated_name(std::string_view name, int64_t number);

// Coordinates are multiplied by `length`. Knots, points and weights are written so that they read back bit for bit, but homogeneous
// points, which are divided by their weights, and equal weights, which are left out. Precondition: check_writable(), or a curve of
// a parameter plane.
int64_t write_spline(ExchangeText &text, const Spline &spline, std::string_view name, double length);

} // namespace nrb::io::step
