// SPDX-License-Identifier: MIT
// A shape that lies far from the origin, moved there. Results that do not depend on where the shape lies,
// such as its derivatives, are then computed without the rounding of coordinates that are all nearly the
// same.
#pragma once

#include "spline/spline.h"

namespace nrb::inline spline {

const Spline::AnyCache &make_at_origin(const Spline &spline);

// Let E be the longest side of the box of the control points that have influence (a weight other than 0, and
// a support in the domain). If every coordinate of some point of the box is at most 8 E, the result is the
// spline itself. Otherwise it is the spline minus the corner O of the box nearest to the origin, where O has
// 0 for the coordinates in which the box is longer than it is far. So no |P - O| in it is more than |P| or 9
// E; Cartesian points in it are moved without error, homogeneous records with one rounding. The moved spline
// is a table of the stored one, made at first use, which may throw std::bad_alloc.
inline const Spline &at_origin(const Spline &spline) {
    const Spline::AnyCache *ready = spline.slot(Spline::Cache::at_origin).peek();
    const Spline::AnyCache &table = ready != nullptr ? *ready : make_at_origin(spline);
    return table == nullptr ? spline : *static_cast<const Spline *>(table.get());
}

} // namespace nrb::inline spline
