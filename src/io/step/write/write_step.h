// SPDX-License-Identifier: MIT
// Writing STEP: an exchange structure by AP214.
#pragma once

#include "io/write_settings.h"
#include "model/model.h"

#include <string>

namespace nrb::io {

// Reads back as the same model by read_step_model() if the unit stays: knots, points, weights, kinds of curves and surfaces, names,
// colours, parts and their uses. The same model is the same text, whenever and wherever it is written. Throws Status::options for a
// unit that cannot be reached, axes, dimension, degree and weight_sign for splines that STEP cannot hold, matrix for placements,
// not_representable; all name the index.
std::string write_step(const model::Model &model, const WriteSettings &settings);

} // namespace nrb::io
