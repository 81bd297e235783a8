// SPDX-License-Identifier: MIT
// Reading IGES: the faces, edges and vertices of a file.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

// Faces are trimmed and bounded surfaces (144, 143), faces of shells and solids (510), and, over their whole
// domain, surfaces that are not part of any other entity. The tolerance of a face is the resolution of the
// file, multiplied by a power of ten where its edges need that, which a note reports. Edges of lists (504)
// are shared; others belong to their face alone. Curves that are not part of any other entity become splines
// of the model. Notes and errors are as those of read_iges(). The first part has the name of the product.
model::Model read_iges_model(std::span<const char> bytes, const ReadSettings &settings);

namespace iges {

// The largest gap between edges that is closed: a fraction of the size of the surface. Writers often state
// the number of printed digits as the resolution, however accurate their edges are.
double largest_gap(const Spline &surface);

} // namespace iges
} // namespace nrb::io
