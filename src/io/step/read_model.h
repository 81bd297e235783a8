// SPDX-License-Identifier: MIT
// Reads the faces, edges and vertices of a STEP file (an exchange structure).
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

// The faces with their edges, and the curves and surfaces that belong to neither. The tolerance of a face is
// the uncertainty of its context or, if its edges need a larger one, that times a power of ten; a note then
// says so. Notes and errors are as those of read_step().
model::Model read_step_model(std::span<const char> bytes, const ReadSettings &settings);

} // namespace nrb::io
