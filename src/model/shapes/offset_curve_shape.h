// SPDX-License-Identifier: MIT
// Offsets of curves as files state them.
#pragma once

#include "fit/offset/offset_curve.h"
#include "model/shapes/curve_shape.h"

#include <span>

namespace nrb::model {

struct MadeCurve {
    CurveShapePtr curve;
    // From what is stated, at equal parameters of the splines, at most; 0: but for rounding.
    double distance = 0;
    bool turns_back = false; // fit::OffsetCurve
    double missed = 0;       // the tolerance above which the distance is, if it is
};

// Whether the offset is a known curve again, exact but for rounding and over the same parameters: of lines, also as splines, of
// circles around the reference direction, and of parts of these. A circle whose radius would become negative starts at its other side.
bool has_known_offset(const CurveShape &basis, const fit::CurveOffset &offset);

// The known offset, or a spline over the parameters of that of the basis; composite curves are made of both. `gap`: between the pieces
// of those at most (curve_spline.h). Throws Status::length for a curve without ends that has no known offset, and for a circle of
// radius 0; gap where pieces of a composite curve meet in a corner; what fit::offset_curve() throws.
MadeCurve offset_curve_shape(const CurveShapePtr &basis, const fit::CurveOffset &offset,
                             const fit::OffsetRule &rule, double gap);

// An offset of an offset and so on, from the innermost distance on, all about one reference direction: the sum of the distances, each
// along the normal of the curve before it. Throws Status::unsupported where that is not known to be on one side.
MadeCurve offset_curve_shape(const CurveShapePtr &basis, std::span<const double> distances,
                             const Vector3 &reference, const fit::OffsetRule &rule, double gap);

} // namespace nrb::model
