// SPDX-License-Identifier: MIT
// Reading STEP: the faces, edges and vertices of an exchange structure.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

// The faces with their edges, and the curves and surfaces that neither consists of. A face has the uncertainty of its context as
// its tolerance, or one larger by powers of ten where its edges need that, which a note tells. Notes and errors are as those of
// read_step().
model::Model read_step_model(std::span<const char> bytes, const ReadSettings &settings);

} // namespace nrb::io
