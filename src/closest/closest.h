// SPDX-License-Identifier: MIT
// Closest-point queries in batches.
#pragma once

#include "base/records.h"
#include "closest/locator.h"

namespace nrb::closest {

// Output arrays of a batch. Records without data are not computed.
struct FeetOutputs {
    Records params;    // [axes]
    Records feet;      // [dim]
    Records distances; // [1]
    int32_t *status = nullptr;
};

// The default budget of a query: the number of pieces examined for one point if the caller sets no limit. It
// allows each piece of the spline to be examined several times, which takes at most about a second.
int64_t usual_budget(const Spline &spline);

// Answers each query whose point is finite; the others get NaN and closest_invalid. `common` holds the data
// that all queries share; its `point` is ignored.
void closest_points(const Spline &spline, const ConstRecords &points, const Query &common,
                    const FeetOutputs &out);
void closest_local(const Spline &spline, const ConstRecords &points, const ConstRecords &guesses,
                   const FeetOutputs &out);

} // namespace nrb::closest
