// SPDX-License-Identifier: MIT
// Local extrema and saddles of scalar splines.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "intersect/extrema/extrema.h"
#include "spline/kind.h"

#include <algorithm>
#include <utility>
#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

using intersect::Extremum;

constexpr uint32_t all_kinds = NURBS_EXTREMUM_MINIMUM | NURBS_EXTREMUM_MAXIMUM | NURBS_EXTREMUM_SADDLE |
                               NURBS_EXTREMUM_PLATEAU | NURBS_EXTREMUM_UNDECIDED;

// Output arrays for extrema; each may be NULL.
struct ExtremumArrays {
    double *params, *values;
    int32_t *found;
    double *boxes;
};

void put_extremum(const ExtremumArrays &out, size_t i, size_t axes, const Extremum &extremum) {
    for (size_t k = 0; k < axes; ++k) {
        put(out.params, i * axes + k, extremum.at[k]);
        put(out.boxes, 2 * (i * axes + k), extremum.range[k].lower);
        put(out.boxes, 2 * (i * axes + k) + 1, extremum.range[k].upper);
    }
    put(out.values, i, extremum.value);
    put(out.found, i, static_cast<int32_t>(extremum.kinds));
}

} // namespace

nurbs_status nurbs_extrema(const nurbs *g, uint32_t kinds, int64_t cap, double *params, double *values,
                           int32_t *found, double *boxes, int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_dimension(spline, 1, 1);
        if ((kinds & ~all_kinds) != 0) {
            fail(Status::flags, "kinds = 0x%x, expected a sum of NURBS_EXTREMUM_ constants", kinds);
        }
        check_length(cap, "cap");
        intersect::Extrema extrema = intersect::extrema_of(g->spline);
        const bool is_complete = extrema.complete();
        std::erase_if(extrema.list, [&](const Extremum &x) { return (x.kinds & kinds) == 0; });
        const int64_t filled = checked_cap(cap, std::ssize(extrema.list)), axes = spline.axes();
        check_apart({memory("params", params, filled * axes), memory("values", values, filled),
                     memory("found", found, filled), memory("boxes", boxes, 2 * filled * axes),
                     memory("count", count, 1), memory("complete", complete, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put_extremum({params, values, found, boxes}, i, static_cast<size_t>(axes), extrema.list[i]);
        }
        put(count, int64_t{std::ssize(extrema.list)});
        put(complete, int32_t{is_complete});
    });
}
