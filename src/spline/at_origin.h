// SPDX-License-Identifier: MIT
// A shape that lies far from the origin, translated to it. Results that do not depend on its position, such
// as its derivatives, are then computed without the rounding errors of coordinates that are all nearly equal.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

const Spline::AnyCache &make_at_origin(const Spline &spline);

// Let E be the longest side of the bounding box of the control points that have influence (their weight is
// not 0, and their support meets the domain). If the box contains a point all of whose coordinates are at
// most 8 E in magnitude, the result is the spline itself. Otherwise it is the spline minus O, the corner of
// the box nearest to the origin; coordinates in which the box is longer than it is far from 0 are 0 in O. So
// |P - O| is at most |P| or 9 E for every P in the box. Cartesian points in the box are moved without error,
// homogeneous records with one rounding. The moved spline is kept with the stored one. It is made at first
// use, which may throw std::bad_alloc.
inline const Spline &at_origin(const Spline &spline) {
    const Spline::AnyCache *ready = spline.slot(Spline::Cache::at_origin).peek();
    const Spline::AnyCache &table = ready != nullptr ? *ready : make_at_origin(spline);
    return table == nullptr ? spline : *static_cast<const Spline *>(table.get());
}

} // namespace nrb::inline spline
