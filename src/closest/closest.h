// SPDX-License-Identifier: MIT
// Batches of queries for closest points.
#pragma once

#include "base/records.h"
#include "closest/locator.h"

namespace nrb::closest {

// Arrays without data are not wanted.
struct FeetOutputs {
    Records params;    // [axes]
    Records feet;      // [dim]
    Records distances; // [1]
    int32_t *status = nullptr;
};

// Pieces examined for a point where the caller sets no limit: each piece of the spline several times, which takes about a
// second at most.
int64_t usual_budget(const Spline &spline);

// Answers each query whose point is finite; the others get NaN and closest_invalid. `common` holds what the
// queries have in common.
void closest_points(const Spline &spline, const ConstRecords &points, const Query &common,
                    const FeetOutputs &out);
void closest_local(const Spline &spline, const ConstRecords &points, const ConstRecords &guesses,
                   const FeetOutputs &out);

} // namespace nrb::closest
