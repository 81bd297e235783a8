// SPDX-License-Identifier: MIT
// Offset curves as files state them.
#pragma once

#include "io/limits.h"
#include "model/shapes/offset_curve_shape.h"

#include <string>

namespace nrb::io {

// The offset of a curve within a quarter of the tolerance that the file states. `stated`: that tolerance; 0:
// none, and then usual_tolerance counts. A bounded curve in the plane lies in a plane of parameters; its
// tolerance is a share of its size near rounding.
model::MadeCurve stated_offset(Limits &limits, const model::CurveShapePtr &basis,
                               const fit::CurveOffset &offset, double stated);
// The same for a chain of offsets, each of the one before, all about one reference direction. `distances`:
// from the innermost offset on.
model::MadeCurve stated_offset(Limits &limits, const model::CurveShapePtr &basis,
                               std::span<const double> distances, const Vector3 &reference, double stated);

// The text of a note on an offset that is not exactly that of the file, or that runs backwards in places;
// otherwise empty.
std::string note_on(const model::MadeCurve &made);

} // namespace nrb::io
