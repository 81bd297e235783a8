// SPDX-License-Identifier: MIT
// Reading STEP: the curves and surfaces of an exchange structure by AP203, AP214, AP242 and what is like them.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

// The surfaces of all faces, the curves of all edges, and the curves and surfaces that nothing else is made of, each in
// the order of their instance numbers. Surfaces without ends are cut to the boundary of their face. Notes name what is
// not read: `line` is the number of the instance, and the type is 0. Throws Error: Status::truncated,
// syntax (the structure is broken; the message names the line), format for schemas of other kinds, options. What is wrong
// inside an instance becomes a note, and does not affect those that do not need it. Without any unit of length
// metres_per_unit is 0. Cost: O(bytes) time and memory, however the instances name each other.
// Precondition: begins_step(bytes), and the settings have been checked.
model::Model read_step(std::span<const char> bytes, const ReadSettings &settings);

} // namespace nrb::io
