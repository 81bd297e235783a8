// SPDX-License-Identifier: MIT
// Reading IGES: the faces, edges and vertices of a file.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

// Faces are trimmed and bounded surfaces (144, 143), faces of shells and solids (510), and surfaces that nothing else consists of,
// over their whole domain. A face has the resolution of the file as its tolerance, or one larger by powers of ten where its edges
// need that, which a note tells. Edges of lists (504) are shared; others are those of their face alone. The curves that nothing
// else consists of are in the splines. Notes and errors are as those of read_iges().
// The first part has the name of the product.
model::Model read_iges_model(std::span<const char> bytes, const ReadSettings &settings);

namespace iges {

// Writers state the digits that they print as the resolution, whatever their edges are worth: gaps that are no larger than this, a
// part of the size of the surface, are closed.
double largest_gap(const Spline &surface);

} // namespace iges
} // namespace nrb::io
