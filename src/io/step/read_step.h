// SPDX-License-Identifier: MIT
// Reads the curves and surfaces of a STEP file (an exchange structure) by AP203, AP214, AP242 or similar
// schemas.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

// The surfaces of all faces, the curves of all edges, and the curves and surfaces that are not parts of
// others, each group in the order of instance numbers. Unbounded surfaces are cut to the boundaries of their
// faces. Notes name what is not read: their `line` is the number of the instance, their type is 0. Throws
// Error: Status::truncated, syntax if the structure is broken (the message names the line), format for
// schemas of other kinds, options. An error inside an instance becomes a note, and does not affect the
// instances that do not need it. Without any unit of length, metres_per_unit is 0. Cost: O(bytes) time and
// memory, however the instances refer to each other.
// Precondition: begins_step(bytes), and the settings have been checked.
model::Model read_step(std::span<const char> bytes, const ReadSettings &settings);

} // namespace nrb::io
