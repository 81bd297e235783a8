// SPDX-License-Identifier: MIT
// Single units, and the measures of a context that they make.
#pragma once

#include "io/step/contexts.h"

#include <optional>
#include <string_view>

namespace nrb::io::step {

enum class Quantity { length, angle, other };

struct Unit {
    Quantity quantity = Quantity::other;
    double factor = 1; // metres or radians
};

// An SI unit with its prefix, or one by conversion from another. Factors that are a degree or an inch but for the digits
// that a file gives are those exactly. Throws Status::syntax.
Unit read_unit(Entities &entities, const Instance &instance);

// The SI prefix of a metre that has so many metres: empty for 1, none if there is no such prefix.
std::optional<std::string_view> prefix_of(double metres) noexcept;

// The units and the uncertainty of a context. Throws Status::syntax.
Measures read_measures(Entities &entities, const Instance &context);

} // namespace nrb::io::step
