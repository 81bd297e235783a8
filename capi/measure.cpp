// Lengths, areas and moments.
#include "checks.h"
#include "guard.h"

#include "base/tolerance.h"
#include "query/measure/curve_length.h"

#include <algorithm>
#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

const Spline &curve_of(const nurbs *g) {
    const Spline &spline = spline_of(g);
    if (spline.axes() != 1) {
        fail(NURBS_ERROR_AXES, "g has %d axes, expected a curve", spline.axes());
    }
    return spline;
}

// The part of an axis that `range` names, or all of it.
Interval range_of(const Spline &spline, int axis, const double *range) {
    const Interval domain = spline.axis(axis).domain();
    if (range == nullptr) {
        return domain;
    }
    check_place(range[2 * axis], domain, "range", axis);
    check_place(range[2 * axis + 1], domain, "range", axis);
    if (!(range[2 * axis] < range[2 * axis + 1])) {
        fail(NURBS_ERROR_EMPTY_DOMAIN, "range[%d] = %s is not below range[%d] = %s", 2 * axis,
             Number(range[2 * axis]).text, 2 * axis + 1, Number(range[2 * axis + 1]).text);
    }
    return {range[2 * axis], range[2 * axis + 1]};
}

} // namespace

nurbs_status nurbs_curve_length(const nurbs *g, const double *range, double relative_tolerance,
                                double *length, double *error) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_tolerance(relative_tolerance, "relative_tolerance");
        require(length, "length");
        check_apart({memory("length", length, 1), memory("error", error, 1)}, {memory("range", range, 2)});
        const Integral found = curve_length(curve, range_of(curve, 0, range), relative_tolerance);
        *length = found.value;
        if (error != nullptr) {
            *error = found.error;
        }
    });
}
