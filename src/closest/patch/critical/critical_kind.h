// SPDX-License-Identifier: MIT
// Classification of places at which the distance is critical along a face.
#pragma once

#include "closest/patch/critical/critical_query.h"
#include "closest/patch/critical/patch_face.h"

namespace nrb::closest {

// A critical_ constant, from the inward derivatives at the boundary and the second derivatives along the
// face.
int32_t kind_at(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                const AxisValues &at);

// Where a tangent vanishes, the derivative of the distance along it vanishes too, wherever the query point
// is. At a pole, where a whole line of parameters is one point, the place is therefore critical only if the
// distance is critical in all directions that meet there. At a cusp, where the points along that axis differ,
// the place counts as critical.
bool is_critical(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                 const AxisValues &at);

} // namespace nrb::closest
