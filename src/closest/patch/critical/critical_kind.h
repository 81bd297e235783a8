// SPDX-License-Identifier: MIT
// What a place is at which the distance is critical along a face.
#pragma once

#include "closest/patch/critical/critical_query.h"
#include "closest/patch/critical/patch_face.h"

namespace nrb::closest {

// A critical_ constant, by the slopes inwards and the second derivatives along the face.
int32_t kind_at(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                const AxisValues &at);

// Where a tangent vanishes at a pole the derivative along it does too, whatever the point: there all
// directions count. At a cusp, where points elsewhere along the axis are others, the place is critical all
// the same.
bool is_critical(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                 const AxisValues &at);

} // namespace nrb::closest
