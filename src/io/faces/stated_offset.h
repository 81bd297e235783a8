// SPDX-License-Identifier: MIT
// Offset curves as files state them.
#pragma once

#include "io/limits.h"
#include "model/shapes/offset_curve_shape.h"

#include <string>

namespace nrb::io {

// The offset within a quarter of the tolerance that the file states, 0 if it states none; in the plane, where that is one of
// parameters, within what is next to nothing of the size of the curve.
model::MadeCurve stated_offset(Limits &limits, const model::CurveShapePtr &basis,
                               const fit::CurveOffset &offset, double stated);
// The same of offsets of each other about one reference direction, from the innermost one on.
model::MadeCurve stated_offset(Limits &limits, const model::CurveShapePtr &basis,
                               std::span<const double> distances, const Vector3 &reference, double stated);

// What a note says on an offset that is not the one of the file, or has places where it turns around; empty for others.
std::string note_on(const model::MadeCurve &made);

} // namespace nrb::io
