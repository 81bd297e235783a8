// SPDX-License-Identifier: MIT
// Offsets of curves in analytic form.
#pragma once

#include "fit/offset/offset_curve.h"
#include "model/shapes/curve_shape.h"

#include <span>

namespace nrb::model {

struct MadeCurve {
    CurveShapePtr curve;
    // A bound of the distance from the exact offset at equal parameters of the splines; 0: exact but for
    // rounding.
    double distance = 0;
    bool turns_back = false; // as in fit::OffsetCurve
    double missed = 0;       // the tolerance, if the distance exceeds it
};

// Whether the offset is a curve of the same kind, exact but for rounding and over the same parameters. That
// is so for lines, also as splines, for circles about the reference direction, and for parts of these. A
// circle whose radius would become negative starts at the opposite point.
bool has_known_offset(const CurveShape &basis, const fit::CurveOffset &offset);

// The known offset if there is one, else a spline over the parameters of the spline of the basis. A composite
// curve is offset piece by piece. `gap`: the largest distance between its pieces, as for composite_curve().
// Throws Status::length for an unbounded curve without a known offset, and for a circle that would get the
// radius 0; gap where pieces of a composite curve meet at a corner; and what fit::offset_curve() throws.
MadeCurve offset_curve_shape(const CurveShapePtr &basis, const fit::CurveOffset &offset,
                             const fit::OffsetRule &rule, double gap);

// The offset of an offset, and so on: the distances from the innermost one on, all about one reference
// direction. It is the offset of the basis by the sum of the distances, each along the normal of the curve
// before it. Throws Status::unsupported if it is not known that such a normal is on one side of the basis
// everywhere.
MadeCurve offset_curve_shape(const CurveShapePtr &basis, std::span<const double> distances,
                             const Vector3 &reference, const fit::OffsetRule &rule, double gap);

} // namespace nrb::model
