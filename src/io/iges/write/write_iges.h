// SPDX-License-Identifier: MIT
// Writing IGES: the fixed-length form of IGES 5.3.
#pragma once

#include "io/write_settings.h"
#include "model/model.h"

#include <string>

namespace nrb::io {

// Writes a file that read_iges_model() reads back as the same model if the unit is kept: knots, points,
// weights, names, colours, parts and their uses. Curves and surfaces keep their kinds where reading these
// gives the same splines; otherwise they are written as splines. The same model always gives the same text.
// Throws Status::options for a unit that cannot be converted to; axes, dimension, degree and weight_sign for
// splines that IGES cannot represent; matrix for placements; not_representable; all name the index; too_large
// for files with more lines than can be numbered.
std::string write_iges(const model::Model &model, const WriteSettings &settings);

} // namespace nrb::io
