// SPDX-License-Identifier: MIT
// The colours of entities.
#pragma once

#include "io/iges/geometry/entities.h"

#include <array>
#include <map>
#include <optional>

namespace nrb::io::iges {

class Colours {
public:
    explicit Colours(Entities &entities) noexcept : entities_(entities) {}

    // Red, green and blue from 0 to 1: one of the eight colours numbered by the standard, or that of a
    // definition (314). Empty if the entity has no colour, or one that cannot be read.
    std::optional<std::array<double, 3>> of(const Entry &entry);

private:
    using Colour = std::optional<std::array<double, 3>>;
    Colour read(int64_t pointer);

    Entities &entities_;
    std::map<int64_t, Colour> definitions_; // those read already
};

} // namespace nrb::io::iges
