// SPDX-License-Identifier: MIT
// Writing IGES: the fixed-length form of IGES 5.3.
#pragma once

#include "io/write_settings.h"
#include "model/model.h"

#include <string>

namespace nrb::io {

// Reads back as the same model by read_iges_model() if the unit stays: knots, points, weights, names, colours, parts and their uses.
// Curves and surfaces are what they were in a file where reading that gives the same splines, else they are splines. The same model
// is the same text, whenever and wherever it is written. Throws Status::options for a unit that cannot be reached, axes, dimension,
// degree and weight_sign for splines that IGES cannot hold, matrix for placements, not_representable; all name the index; too_large
// for files with more lines than can be numbered.
std::string write_iges(const model::Model &model, const WriteSettings &settings);

} // namespace nrb::io
