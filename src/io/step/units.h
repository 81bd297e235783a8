// SPDX-License-Identifier: MIT
// Reads single units, and the measures of a context, which they make up.
#pragma once

#include "io/step/contexts.h"

#include <optional>
#include <string_view>

namespace nrb::io::step {

enum class Quantity { length, angle, other };

struct Unit {
    Quantity quantity = Quantity::other;
    double factor = 1; // in metres or radians
};

// Reads an SI unit with its prefix, or a unit that is defined by conversion from another one. A factor that
// is a degree, a gon, an inch, a foot or a yard, but for the digits in the file, is set to the exact value.
// Throws Status::syntax.
Unit read_unit(Entities &entities, const Instance &instance);

// The SI prefix of the metre that is `metres` long: empty for 1; none if there is no such prefix.
std::optional<std::string_view> prefix_of(double metres) noexcept;

// The units and the uncertainty of a context. Throws Status::syntax.
Measures read_measures(Entities &entities, const Instance &context);

} // namespace nrb::io::step
